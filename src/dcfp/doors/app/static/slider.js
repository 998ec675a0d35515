// A slider of the browser's own, with its value beside the label; the value is written here, so that it never lags behind.
export default {
  template: `
    <div class="field">
      <div class="slider-row">
        <label class="field-label" :for="'slider-' + name">{{ label }}</label>
        <output class="value" :for="'slider-' + name">{{ words }}</output>
      </div>
      <input type="range" class="slider" :id="'slider-' + name" :min="least" :max="most" :step="step" :value="now"
        :disabled="off" :aria-valuetext="words" @input="move" />
    </div>`,
  props: { name: Number, label: String, unit: String, decimals: Number, least: Number, most: Number, step: Number, value: Number, off: Boolean },
  data() {
    return { now: this.value };
  },
  computed: {
    words() {
      return `${this.now.toFixed(this.decimals)} ${this.unit}`;
    },
  },
  methods: {
    move(event) {
      this.now = Number(event.target.value);
      this.$emit("move", this.now);
    },
  },
};
