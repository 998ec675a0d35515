// The plate seen from above at the moment that a slider chooses. All moments are sent once, as parts of one image.
const EDGE = 46;

export default {
  template: `
    <div class="plate">
      <canvas ref="canvas" role="img" :aria-label="words"></canvas>
      <div class="section-controls">
        <input type="range" min="0" :max="last" step="1" :value="now" :disabled="!ready" @input="scrub"
          aria-label="Moment of the plate" :aria-valuetext="words" />
      </div>
      <p class="plate-words">{{ words }}</p>
    </div>`,
  data: () => ({ now: 0, last: 0, ready: false, words: "" }),
  mounted() {
    this.sizes = new ResizeObserver(() => this.paint());
    this.sizes.observe(this.$refs.canvas);
    this.themes = new MutationObserver(() => this.paint());
    this.themes.observe(document.body, { attributes: true, attributeFilter: ["class"] });
  },
  unmounted() {
    this.sizes.disconnect();
    this.themes.disconnect();
  },
  methods: {
    // places are in mm on the plate, from its middle; temperatures in degC
    load(scene) {
      const image = new Image();
      this.latest = image;
      image.onload = () => {
        if (this.latest !== image) return; // something newer came meanwhile
        this.image = image;
        this.scene = Object.freeze(scene);
        this.last = scene.times.length - 1;
        this.now = scene.shows;
        this.ready = true;
        this.paint();
      };
      image.src = scene.url;
    },
    scrub(event) {
      this.now = Number(event.target.value);
      this.paint();
    },
    paint() {
      const canvas = this.$refs.canvas;
      if (!this.scene || !canvas || canvas.clientWidth === 0) return;
      const density = window.devicePixelRatio || 1;
      const width = canvas.clientWidth;
      const height = canvas.clientHeight;
      canvas.width = Math.round(width * density);
      canvas.height = Math.round(height * density);
      const pen = canvas.getContext("2d");
      pen.scale(density, density);
      const style = getComputedStyle(document.body);
      this.drawPlate(pen, Math.min(width - EDGE, height));
      this.drawColours(pen, width, Math.min(width - EDGE, height), style.getPropertyValue("--muted").trim());
      const { times, hottest, length } = this.scene;
      const [x, y, hot] = hottest[this.now];
      const place = [x, y].map((one) => (one / length.size).toFixed(length.decimals)).join(", ");
      this.words = `${times[this.now].toFixed(2)} s: hottest point ${this.heat(hot)} at ${place} ${length.unit}`;
    },
    heat(temperature) {
      const { size, zero, unit } = this.scene.heat;
      return `${(temperature / size + zero).toFixed(0)} ${unit}`;
    },
    drawPlate(pen, side) {
      const { across, width, height, left, top, spacing, path, ends, hottest, radius, colours, length } = this.scene;
      const reach = 1.04 * Math.max(-left, top, left + width * spacing, height * spacing - top);
      const scale = side / (2 * reach);
      const place = (x, y) => [side / 2 + x * scale, side / 2 - y * scale];
      pen.fillStyle = colours[0];
      pen.fillRect(0, 0, side, side);
      const column = this.now % across;
      const row = Math.floor(this.now / across);
      pen.drawImage(
        this.image, column * width, row * height, width, height,
        ...place(left, top), width * spacing * scale, height * spacing * scale,
      );
      pen.save();
      pen.beginPath();
      pen.rect(0, 0, side, side);
      pen.clip();
      pen.strokeStyle = "white";
      pen.lineWidth = 0.8;
      pen.beginPath();
      for (let i = 0; i <= ends[this.now]; i += 1) (i ? pen.lineTo(...place(...path[i])) : pen.moveTo(...place(...path[i])));
      pen.stroke();
      pen.lineWidth = 1.3;
      pen.setLineDash([5, 4]);
      pen.beginPath();
      pen.arc(...place(...path[ends[this.now]]), radius * scale, 0, 2 * Math.PI);
      pen.stroke();
      pen.setLineDash([]);
      const [x, y] = place(...hottest[this.now]);
      pen.beginPath();
      pen.arc(x, y, 3.5, 0, 2 * Math.PI);
      pen.fillStyle = "black";
      pen.fill();
      pen.lineWidth = 1;
      pen.stroke();
      // a bar that says how large it is
      const bar = length.unit === "in" ? 101.6 : 100;
      pen.fillStyle = "white";
      pen.fillRect(10, side - 12, bar * scale, 2);
      pen.font = "12px system-ui, sans-serif";
      pen.textAlign = "left";
      pen.fillText(`${(bar / length.size).toFixed(0)} ${length.unit}`, 10, side - 17);
      pen.restore();
    },
    drawColours(pen, width, side, ink) {
      const { colours, low, high } = this.scene;
      const tall = Math.min(160, side - 40);
      const top = (side - tall) / 2;
      const shades = pen.createLinearGradient(0, top + tall, 0, top);
      colours.forEach((one, i) => shades.addColorStop(i / (colours.length - 1), one));
      pen.fillStyle = shades;
      pen.fillRect(side + 10, top, 12, tall);
      pen.fillStyle = ink;
      pen.font = "12px system-ui, sans-serif";
      pen.textAlign = "left";
      pen.fillText(this.heat(high), side + 6, top - 6);
      pen.fillText(this.heat(low), side + 6, top + tall + 16);
    },
  },
};
