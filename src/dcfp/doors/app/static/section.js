// The bearing in section, moving to scale: two concave plates and the slider between them, coloured by temperature.
const SPEEDS = [0.25, 0.5, 1, 2, 5];

export default {
  template: `
    <div class="section">
      <canvas ref="canvas" role="img" :aria-label="words"></canvas>
      <div class="section-controls">
        <button type="button" class="plain-button" :disabled="!ready" @click="toggle" :aria-label="playing ? 'Pause' : 'Play'">
          <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
            <path v-if="playing" d="M3 2h4v12H3zM9 2h4v12H9z" fill="currentColor" />
            <path v-else d="M3 1.5v13l11-6.5z" fill="currentColor" />
          </svg>
        </button>
        <input type="range" min="0" :max="last" step="0.01" :value="now" :disabled="!ready" @input="scrub"
          aria-label="Time in the record" :aria-valuetext="now.toFixed(2) + ' seconds'" />
        <label class="section-speed"><span class="unseen">Speed of the animation</span>
          <select v-model.number="speed"><option v-for="one in speeds" :value="one">{{ one }} ×</option></select>
        </label>
      </div>
      <p class="section-words">{{ words }}</p>
    </div>`,
  data: () => ({ now: 0, last: 0, speed: 1, speeds: SPEEDS, playing: false, ready: false, words: "" }),
  mounted() {
    this.calm = matchMedia("(prefers-reduced-motion: reduce)");
    this.sizes = new ResizeObserver(() => this.paint());
    this.sizes.observe(this.$refs.canvas);
    this.themes = new MutationObserver(() => this.paint());
    this.themes.observe(document.body, { attributes: true, attributeFilter: ["class"] });
  },
  unmounted() {
    cancelAnimationFrame(this.frame);
    this.sizes.disconnect();
    this.themes.disconnect();
  },
  methods: {
    // `scene` holds equally spaced histories and the geometry, all in mm, s and degC, and how to show them
    load(scene) {
      this.scene = Object.freeze(scene);
      this.last = scene.step * (scene.displacement.length - 1);
      this.ready = true;
      if (!this.playing) this.now = scene.shows;
      this.now = Math.min(this.now, this.last);
      this.paint();
    },
    toggle() {
      this.playing = !this.playing;
      if (!this.playing) return cancelAnimationFrame(this.frame);
      if (this.now >= this.last - 1e-6) this.now = 0;
      this.before = null;
      this.frame = requestAnimationFrame(this.advance);
    },
    advance(stamp) {
      if (!this.playing) return;
      this.before ??= stamp;
      const passed = ((stamp - this.before) / 1000) * this.speed;
      // who wants little motion gets still pictures, one every second
      if (!this.calm.matches || stamp - this.before >= 1000) {
        this.before = stamp;
        this.now = Math.min(this.now + passed, this.last);
        this.paint();
      }
      if (this.now >= this.last) this.playing = false;
      else this.frame = requestAnimationFrame(this.advance);
    },
    scrub(event) {
      this.now = Number(event.target.value);
      this.paint();
    },
    at(values) {
      const place = Math.min(this.now / this.scene.step, values.length - 1);
      const first = Math.floor(place);
      const second = Math.min(first + 1, values.length - 1);
      return values[first] + (place - first) * (values[second] - values[first]);
    },
    colour(temperature) {
      const { colours, low, high } = this.scene;
      const share = high > low ? (temperature - low) / (high - low) : 0;
      return colours[Math.max(0, Math.min(colours.length - 1, Math.round(share * (colours.length - 1))))];
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
      const ink = style.getPropertyValue("--ink").trim();
      const steel = style.getPropertyValue("--steel").trim();
      const edge = style.getPropertyValue("--muted").trim();
      const y = this.at(this.scene.displacement);
      const hot = this.at(this.scene.temperature);
      this.drawBearing(pen, width, height, y, hot, { ink, steel, edge });
      const { length, heat } = this.scene;
      this.words =
        `${this.now.toFixed(2)} s: displacement ${(y / length.size).toFixed(length.decimals)} ${length.unit}, ` +
        `contact ${(hot / heat.size + heat.zero).toFixed(0)} ${heat.unit}`;
    },
    drawBearing(pen, width, height, y, hot, { ink, steel, edge }) {
      const { radii, diameter, reach, tall } = this.scene;
      const half = reach / 2 + diameter / 2 + 0.12 * diameter;
      const thick = 0.22 * diameter;
      const rise = (half * half) / (2 * Math.min(...radii));
      const scale = Math.min(width / (2 * half + reach + 20), (height - 22) / (tall + 2 * (thick + rise) + 0.1 * diameter));
      const first = radii[0] + tall / 2;
      const second = radii[1] + tall / 2;
      const turn = Math.asin(Math.max(-1, Math.min(1, y / (radii[0] + radii[1]))));
      const place = (x, z) => [width / 2 + (x - y / 2) * scale, height / 2 + 4 - (z - tall / 2) * scale];
      const along = (points) => {
        pen.beginPath();
        points.forEach(([x, z], i) => (i ? pen.lineTo(...place(x, z)) : pen.moveTo(...place(x, z))));
        pen.closePath();
      };
      const bowl = (radius, middle, side, base) => {
        const points = [];
        for (let i = 0; i <= 48; i += 1) {
          const x = -half + (2 * half * i) / 48;
          points.push([middle + x, base + side * (radius - Math.sqrt(radius * radius - x * x))]);
        }
        const back = base + side * -thick;
        points.push([middle + half, back], [middle - half, back]);
        return points;
      };
      const contact = [first * Math.sin(turn), first * (1 - Math.cos(turn))];
      const axis = [-Math.sin(turn), Math.cos(turn)];
      const top = [contact[0] + tall * axis[0], contact[1] + tall * axis[1]];
      const centre = [top[0] - second * axis[0], top[1] - second * axis[1]];
      pen.lineWidth = 1;
      pen.strokeStyle = edge;
      pen.fillStyle = steel;
      for (const points of [bowl(first, 0, 1, 0), bowl(second, centre[0], -1, centre[1] + second)]) {
        along(points);
        pen.fill();
        pen.stroke();
      }
      const face = (middle, radius, at, side) => {
        const points = [];
        for (let i = 0; i <= 24; i += 1) {
          const away = ((i / 12 - 1) * diameter) / 2 / radius;
          points.push([
            middle[0] + radius * side * Math.sin(at + away * side),
            middle[1] - radius * side * Math.cos(at + away * side),
          ]);
        }
        return points;
      };
      const below = face([0, first], first, turn, 1);
      const above = face(centre, second, turn, -1);
      if (Math.hypot(below[24][0] - above[0][0], below[24][1] - above[0][1]) > diameter) above.reverse();
      along([...below, ...above]);
      pen.fillStyle = this.colour(hot);
      pen.fill();
      pen.strokeStyle = ink;
      pen.stroke();
      pen.fillStyle = ink;
      pen.font = "12px system-ui, sans-serif";
      pen.textAlign = "left";
      // a bar that says how large it is
      const bar = this.scene.bar;
      pen.fillRect(8, height - 8, bar.mm * scale, 2);
      pen.fillText(bar.words, 8, height - 13);
    },
  },
};
