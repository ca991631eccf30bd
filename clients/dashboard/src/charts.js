// SPDX-License-Identifier: MIT
// Temperature, current, duty and headroom of the last ten minutes: what the daemon kept, then what it tells. All charts show
// the same time, from half a minute to all there is, or what somebody dragged over.
import uPlot from "uplot";

/** What the daemon keeps, and so does the page. */
const kHistoryS = 600;
const kPerSecond = 5;
const kHeight = 128;
/** A longer silence is a gap in the lines, s. */
const kGapS = 5;

const colour = (name) => () => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const grid = { stroke: colour("grid"), width: 1 };

function axis(size, values) {
  return {
    stroke: colour("axis"), grid, ticks: { show: false }, size, font: "11px system-ui, sans-serif", gap: 4, values,
  };
}

function line(label, stroke, more = {}) {
  return { label, stroke: colour(stroke), width: 1.5, points: { show: false }, ...more };
}

/** "now", "-30 s", "-5 min". */
function ago(seconds) {
  if (Math.abs(seconds) < 0.5) return "now";
  return seconds > -100 ? `${Math.round(seconds)} s` : `${(seconds / 60).toFixed(seconds % 60 ? 1 : 0)} min`;
}

/** One chart in `element`, `series` as [label, colour, options]; `time`: what all of them show. */
class Chart {
  constructor(element, series, range, time) {
    this.time = time;
    this.data = [[], ...series.map(() => [])];
    this.plot = new uPlot(
      {
        width: Math.max(element.clientWidth, 120),
        height: kHeight,
        legend: { show: false },
        cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false, setScale: false } },
        padding: [6, 14, 0, 0],
        scales: { x: { time: false, range: () => time.range() }, y: { range } },
        axes: [axis(18, (_, ticks) => ticks.map((t) => ago(t - time.now))), axis(34)],
        series: [{}, ...series.map(([label, stroke, more]) => line(label, stroke, more))],
        hooks: {
          setSelect: [(plot) => {
            if (plot.select.width < 3) return;
            time.zoom([plot.select.left, plot.select.left + plot.select.width].map((x) => plot.posToVal(x, "x")));
            plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
          }],
        },
      },
      this.data,
      element,
    );
    this.plot.axes[0].splits = () => {
      const [from, to] = time.range();
      return [0, 1, 2, 3].map((i) => to - ((to - from) * i) / 4);
    };
    element.addEventListener("dblclick", () => time.zoom(null));
    new ResizeObserver(() => this.plot.setSize({ width: Math.max(element.clientWidth, 120), height: kHeight })).observe(element);
  }

  /** Not drawn yet. */
  put(at, values) {
    const last = this.data[0].at(-1);
    if (at <= last) return;
    if (at - last > kGapS) this.data.forEach((list, i) => list.push(i ? null : last + 0.001));
    [at, ...values].forEach((value, i) => this.data[i].push(value));
    const old = this.data[0].findIndex((t) => t >= at - kHistoryS);
    if (old > 0) this.data.forEach((list) => list.splice(0, old));
  }

  draw() {
    this.plot.setData(this.data);
  }
}

/** What the charts show: the last `span` seconds, or what was dragged over. */
class Shown {
  constructor(changed) {
    this.changed = changed;
    this.now = 0;
    this.span = 120;
    this.zoomed = null;
  }

  range() {
    return this.zoomed ?? [this.now - this.span, this.now];
  }

  show(span) {
    this.span = span;
    this.zoom(null);
  }

  /** [from, to] in seconds of the device; null: the newest again. */
  zoom(range) {
    this.zoomed = range;
    this.changed();
  }
}

const known = (value) => (Number.isFinite(value) ? value : null);
const least = (value) => (value === null || value === undefined ? null : Math.min(value, 60));

export class Charts {
  /** `limits`: of device.describe; `histories`: of telemetry.history, of longer and of shorter times; or none. */
  constructor(root, limits, histories) {
    const place = (name) => root.querySelector(`[data-chart=${name}]`);
    for (const name of ["temperature", "current", "duty", "headroom"]) place(name).replaceChildren();
    const dashed = { dash: [4, 4], width: 1 };
    this.time = new Shown(() => {
      root.querySelector("#newest").classList.toggle("away", !this.time.zoomed);
      this.draw();
    });
    this.marks = [limits.derate_from_c ?? 60, limits.trip_c ?? 70];
    const most = limits.current_a ?? 15;
    this.temperature = new Chart(
      place("temperature"),
      [["thermistor", "blue"], ["hottest winding", "amber"], ["derates", "derates", dashed], ["trips", "trips", dashed],
        ...["x", "y", "z"].map((name) => [`winding ${name}`, name, { show: false }])],
      (_, lowest) => [Math.min(20, Math.floor((lowest ?? 20) - 2)), this.marks[1] + 4], this.time);
    this.current = new Chart(
      place("current"), [["flows", "amber", { fill: () => `${colour("amber")()}22` }], ["allowed", "green"]], [0, most * 1.05], this.time);
    this.duty = new Chart(place("duty"), ["x", "y", "z"].map((name) => [name, name]), [0, 100], this.time);
    this.headroom = new Chart(place("headroom"), [["headroom", "green"]], [0, 60], this.time);
    this.all = [this.temperature, this.current, this.duty, this.headroom];
    this.lastNs = -Infinity;
    this.root = root;
    this.listen();
    this.fill(histories);
    this.each(root.querySelector("[name=each-winding]").checked);
  }

  /** What is chosen stays so over a reconnection, in the page. */
  listen() {
    for (const choice of this.root.querySelectorAll("[name=span]")) {
      choice.onchange = () => this.time.show(Number(choice.value));
      if (choice.checked) this.time.span = Number(choice.value);
    }
    const each = this.root.querySelector("[name=each-winding]");
    each.onchange = () => this.each(each.checked);
    this.root.querySelector("#newest").onclick = () => this.time.zoom(null);
    matchMedia("(prefers-color-scheme: light)").onchange = () => this.all.forEach(({ plot }) => plot.redraw());
  }

  each(shown) {
    this.root.dataset.each = shown;
    for (const i of [5, 6, 7]) this.temperature.plot.setSeries(i, { show: shown });
  }

  /** A shorter one has more of the same time. */
  fill(histories) {
    histories.forEach(({ time_ns: now, samples }, i) => {
      const from = histories[i + 1]?.samples[0]?.age_s ?? -1;
      for (const sample of samples.filter(({ age_s: age }) => age > from)) {
        this.put(now * 1e-9 - sample.age_s, sample.coils_c, sample.sensor_c, sample.peak_a, sample.limit_a, sample.duty, sample.headroom_s);
      }
      this.time.now = now * 1e-9;
    });
    this.draw();
  }

  put(at, coils, sensor, flows, allowed, duty, headroom) {
    const windings = coils ?? [null, null, null];
    const hottest = coils ? Math.max(...coils) : null;
    this.temperature.put(at, [known(sensor), hottest, ...this.marks, ...windings]);
    this.current.put(at, [flows, allowed]);
    this.duty.put(at, duty.map((d) => 100 * Math.abs(d)));
    this.headroom.put(at, [least(headroom)]);
  }

  add(status) {
    if (status.time_ns - this.lastNs < 1e9 / kPerSecond) return;
    this.lastNs = status.time_ns;
    const time = status.time_ns * 1e-9;
    const { sensor, model, coils } = status.temperature_c;
    this.put(time, Number.isFinite(model) ? coils : null, sensor, Math.hypot(...status.current_a), status.limit_a, status.duty, status.headroom_s);
    this.time.now = time;
    if (!this.time.zoomed) this.draw();
  }

  draw() {
    this.all?.forEach((chart) => chart.draw());
  }
}
