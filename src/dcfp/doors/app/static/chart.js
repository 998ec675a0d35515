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

// What every chart looks like; options say only what is different, and what is drawn.
const TEXT = { color: "var(--muted)", fontSize: 12 };
const SHORT = { show: true, lineStyle: { color: "var(--muted)" } };
const AXIS = { type: "value", scale: true, splitNumber: 4 };
const AXES = {
  x: {
    ...AXIS, nameLocation: "middle", nameGap: 26, nameTextStyle: TEXT,
    axisLine: { ...SHORT, onZero: false }, axisTick: SHORT, splitLine: { show: false },
  },
  y: {
    ...AXIS, nameTextStyle: { ...TEXT, align: "left", padding: [0, 0, 0, -36] },
    axisLine: { show: false, onZero: false }, axisTick: { show: false }, splitLine: { show: true },
  },
};
const WORDS = { axisLabel: TEXT, axisTick: { show: false }, axisLine: SHORT };
const LINE = { type: "line", showSymbol: false, symbol: "none", emphasis: { disabled: true }, lineStyle: { width: 1.3 }, z: 3 };
const QUIET = { silent: true, animation: false };
const MARKS = {
  markLine: {
    ...QUIET, symbol: "none", lineStyle: { type: "dashed", width: 1 },
    label: { fontSize: 11, position: "insideEndTop" },
  },
  markPoint: {
    ...QUIET, symbol: "circle", symbolSize: 5, itemStyle: { color: "var(--ink)" },
    label: { show: true, color: "var(--ink)", fontSize: 11, position: "right", distance: 6 },
  },
  markArea: { ...QUIET, itemStyle: { color: "var(--pale)" } },
};
const LEGEND = { show: true, top: 0, right: 4, itemWidth: 16, itemHeight: 8, itemGap: 12, textStyle: TEXT };
const TOOLTIP = {
  trigger: "axis", confine: true, transitionDuration: 0, backgroundColor: "var(--card)", borderColor: "var(--faint)",
  textStyle: { color: "var(--ink)", fontSize: 12 },
  axisPointer: { lineStyle: { color: "var(--muted)" }, label: { show: false } },
};
const GRID = { left: 52, right: 16, top: 34, bottom: 42 };

const isParts = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

// What is given over what is usual, part by part; arrays are taken whole.
function over(usual, given) {
  if (given === undefined) return usual;
  if (!isParts(usual) || !isParts(given)) return given;
  const names = new Set([...Object.keys(usual), ...Object.keys(given)]);
  return Object.fromEntries([...names].map((name) => [name, over(usual[name], given[name])]));
}

function axisOf(place, axis) {
  if (axis.type === "category") return over(WORDS, axis);
  // the ends of an axis are where its data end, seldom at a round number
  const ends = { showMinLabel: axis.min === undefined, showMaxLabel: axis.max === undefined };
  const usual = { ...AXES[place], axisLabel: { ...TEXT, hideOverlap: true, ...ends } };
  return over(over(usual, { splitLine: { lineStyle: { color: "var(--line)" } } }), axis);
}

function seriesOf({ color, ...series }) {
  const found = series.type === undefined ? over(over(LINE, { lineStyle: { color }, itemStyle: { color } }), series) : { ...series };
  for (const [name, usual] of Object.entries(MARKS)) {
    if (series[name] !== undefined) found[name] = over(usual, series[name]);
  }
  return { animation: false, ...found };
}

function dressed(options) {
  const each = (part, dress) => (Array.isArray(part) ? part.map(dress) : dress(part));
  const found = {
    ...options,
    animation: false,
    xAxis: each(options.xAxis, (axis) => axisOf("x", axis)),
    yAxis: each(options.yAxis, (axis) => axisOf("y", axis)),
    // panels above each other have the heights that are given
    grid: each(options.grid ?? {}, (grid) => (grid.height ? { left: GRID.left, right: GRID.right, ...grid } : { ...GRID, ...grid })),
    series: options.series.map(seriesOf),
    tooltip: over(TOOLTIP, options.tooltip),
  };
  if (options.legend) found.legend = each(options.legend, (legend) => over(LEGEND, legend));
  if (options.visualMap) found.visualMap = over({ textStyle: TEXT }, options.visualMap);
  return found;
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
      const { pictures = [], areas = [], ...plain } = dressed(this.latest);
      const fitted = this.$el.clientWidth < 430 ? narrowed(plain) : plain;
      const options = coloured(fitted, getComputedStyle(document.body));
      const shapes = coloured(areas, getComputedStyle(document.body)).map(areaSeries);
      options.series = [...pictures.map(pictureSeries), ...shapes, ...options.series];
      this.chart.setOption(options, { notMerge: true });
      this.$el.dataset.drawn = String(Number(this.$el.dataset.drawn ?? 0) + 1);
    },
  },
};
