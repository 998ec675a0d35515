// Choose files or drop them; each is sent by itself, and what the server refuses is said.
export default {
  template: `
    <div class="drop" :class="{ over }" @dragover.prevent="over = true" @dragleave="over = false" @drop.prevent="drop">
      <label class="drop-label" :for="inputId"><span class="drop-button">Choose files</span> <span>{{ busy ? "Reading …" : hint }}</span></label>
      <input :id="inputId" type="file" multiple @change="choose" class="drop-input" />
    </div>`,
  props: { url: String, maxFileSize: Number, hint: String },
  data: () => ({ over: false, busy: false }),
  computed: {
    inputId() {
      return this.$el?.id ? `${this.$el.id}-files` : `files-${this.url.split("/").pop()}`;
    },
  },
  methods: {
    choose(event) {
      this.send([...event.target.files]);
      event.target.value = "";
    },
    drop(event) {
      this.over = false;
      this.send([...event.dataTransfer.files]);
    },
    async send(files) {
      this.busy = true;
      for (const file of files) {
        if (file.size > this.maxFileSize) {
          this.$emit("too_large", file.name);
          continue;
        }
        const form = new FormData();
        form.append("file", file, file.name);
        try {
          const reply = await fetch((window.path_prefix ?? "") + this.url, { method: "POST", body: form });
          if (!reply.ok) this.$emit("refused", file.name);
        } catch {
          this.$emit("refused", file.name);
        }
      }
      this.busy = false;
    },
  },
};
