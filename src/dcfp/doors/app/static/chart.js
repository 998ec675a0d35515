// A chart whose options are sent once per result. Colours are written as var(--name) and looked up here, so that the
// theme can change without the server; charts that are out of sight wait until they are scrolled to.
import { echarts } from "nicegui-echart";

function coloured(value, style) {
  if (typeof value === "string") {
    return value.replace(/var\((--[\w-]+)\)/g, (_, name) => style.getPropertyValue(name).trim());
  }
  if (Array.isArray(value)) {
    // long arrays are numbers or pairs of numbers
    return value.length > 64 ? value : value.map((one) => coloured(one, style));
  }
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, coloured(one, style)]));
  }
  return value;
}

// An image that spans a part of the axes: { url, x: [from, to], y: [from, to] }.
function pictureSeries(picture) {
  return {
    type: "custom",
    silent: true,
    clip: true,
    z: 1,
    data: [[picture.x[0], picture.y[0]]],
    renderItem: (params, api) => {
      const low = api.coord([picture.x[0], picture.y[0]]);
      const high = api.coord([picture.x[1], picture.y[1]]);
      const box = { x: low[0], y: high[1], width: high[0] - low[0], height: low[1] - high[1] };
      return { type: "image", style: { image: picture.url, ...box } };
    },
  };
}

// A filled polygon: { points: [[x, y], ...], color, opacity }.
function areaSeries(area) {
  return {
    type: "custom",
    silent: true,
    clip: true,
    z: 1,
    data: [area.points[0]],
    renderItem: (params, api) => {
      const { x, y, width, height } = params.coordSys;
      const points = echarts.graphic.clipPointsByRect(
        area.points.map((point) => api.coord(point)),
        { x, y, width, height },
      );
      return { type: "polygon", shape: { points }, style: { fill: area.color, opacity: area.opacity } };
    },
  };
}

// On a narrow screen a legend has a row of its own, above the name of the axis.
function narrowed(options) {
  if (!options.legend?.show || Array.isArray(options.grid)) return options;
  const legend = { ...options.legend, left: 0, right: 0 };
  return { ...options, legend, grid: { ...options.grid, top: options.grid.top + 24 } };
}

export default {
  template: `<div role="img" :aria-label="label"></div>`,
  props: { label: String },
  mounted() {
    this.latest = null;
    this.stale = false;
    this.inSight = false;
    this.sizes = new ResizeObserver(() => {
      this.chart?.resize();
      this.show();
    });
    this.sizes.observe(this.$el);
    this.sights = new IntersectionObserver(
      (entries) => {
        this.inSight = entries[entries.length - 1].isIntersecting;
        this.show();
      },
      { rootMargin: "200px" },
    );
    this.sights.observe(this.$el);
    this.themes = new MutationObserver(() => {
      this.stale = this.latest !== null;
      this.show();
    });
    this.themes.observe(document.body, { attributes: true, attributeFilter: ["class"] });
  },
  unmounted() {
    this.sizes.disconnect();
    this.sights.disconnect();
    this.themes.disconnect();
    this.chart?.dispose();
  },
  methods: {
    draw(options) {
      this.latest = options;
      this.stale = true;
      this.show();
    },
    show() {
      if (!this.stale || !this.inSight || this.$el.clientWidth === 0) return;
      this.stale = false;
      this.chart ??= echarts.init(this.$el, null, { renderer: "canvas" });
      const { pictures = [], areas = [], ...plain } = this.latest;
      const fitted = this.$el.clientWidth < 430 ? narrowed(plain) : plain;
      const options = coloured(fitted, getComputedStyle(document.body));
      const shapes = coloured(areas, getComputedStyle(document.body)).map(areaSeries);
      options.series = [...pictures.map(pictureSeries), ...shapes, ...options.series];
      this.chart.setOption(options, { notMerge: true });
      this.$el.dataset.drawn = String(Number(this.$el.dataset.drawn ?? 0) + 1);
    },
  },
};
