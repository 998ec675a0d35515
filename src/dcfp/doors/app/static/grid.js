// A table of words and numbers; everything is text, nothing is markup.
export default {
  template: `
    <div class="table-frame" tabindex="0" role="region" :aria-label="caption">
      <table>
        <caption class="unseen">{{ caption }}</caption>
        <thead><tr>
          <th v-for="one in head" scope="col" :class="{ number: one.number }">{{ one.text }}<span v-if="one.unit" class="unit">[{{ one.unit }}]</span></th>
        </tr></thead>
        <tbody>
          <tr v-for="(row, i) in rows" :class="{ chosen: i === chosen }">
            <component :is="j ? 'td' : 'th'" :scope="j ? null : 'row'" v-for="(cell, j) in row" :class="[{ number: head[j].number }, cell.tone]">
              <button v-if="pick && j === 0" type="button" class="link" :aria-pressed="i === chosen" @click="$emit('pick', i)">{{ cell.text }}</button>
              <template v-else>{{ cell.text }}</template>
            </component>
          </tr>
        </tbody>
      </table>
    </div>`,
  props: { caption: String, head: Array, rows: Array, chosen: Number, pick: Boolean },
};
