// SPDX-License-Identifier: MIT
// The last two minutes: temperature, current, headroom, duty.
import uPlot from "uplot";

const kSeconds = 120;
const kPerSecond = 5;
const kHeight = 128;
const kAxis = "#8a96ad";
const kGrid = { stroke: "#232c3d", width: 1 };

function axis(size, values) {
  return {
    stroke: kAxis, grid: kGrid, ticks: { show: false }, size, font: "11px system-ui, sans-serif", gap: 4, values,
  };
}

function line(label, stroke, more = {}) {
  return { label, stroke, width: 1.5, points: { show: false }, ...more };
}

/** One chart in `element`, `series` as [label, colour, options]. */
class Chart {
  constructor(element, series, range) {
    this.element = element;
    this.data = [[], ...series.map(() => [])];
    this.plot = new uPlot(
      {
        width: Math.max(element.clientWidth, 120),
        height: kHeight,
        legend: { show: false },
        cursor: { show: false },
        padding: [6, 14, 0, 0],
        scales: { x: { time: false, range: (_, __, most) => [most - kSeconds, most] }, y: { range } },
        axes: [
          axis(18, (_, ticks) => ticks.map((t) => (t === this.now ? "now" : `${Math.round(t - this.now)} s`))),
          axis(34),
        ],
        series: [{}, ...series.map(([label, stroke, more]) => line(label, stroke, more))],
      },
      this.data,
      element,
    );
    this.plot.axes[0].splits = () => [0, -30, -60, -90].map((s) => this.now + s);
    new ResizeObserver(() => this.plot.setSize({ width: Math.max(element.clientWidth, 120), height: kHeight })).observe(element);
  }

  add(time, values) {
    this.now = time;
    [time, ...values].forEach((value, i) => this.data[i].push(value));
    const old = this.data[0].findIndex((t) => t >= time - kSeconds - 1);
    if (old > 0) this.data.forEach((list) => list.splice(0, old));
    this.plot.setData(this.data);
  }
}

export class Charts {
  /** `limits`: of device.describe. */
  constructor(root, limits) {
    const place = (name) => root.querySelector(`[data-chart=${name}]`);
    for (const name of ["temperature", "current", "duty", "headroom"]) place(name).replaceChildren();
    const dashed = { dash: [4, 4], width: 1 };
    this.marks = [limits.derate_from_c ?? 60, limits.trip_c ?? 70];
    this.most = limits.current_a ?? 15;
    this.temperature = new Chart(
      place("temperature"),
      [["sensor", "#6fb1ff"], ["model", "#ffb454"], ["derates", "#a98b4f", dashed], ["trips", "#d9626f", dashed]],
      (_, least) => [Math.min(20, Math.floor((least ?? 20) - 2)), this.marks[1] + 4]);
    this.current = new Chart(
      place("current"), [["flows", "#ffb454", { fill: "#ffb45422" }], ["allowed", "#6fe0b0"]], [0, this.most * 1.05]);
    this.duty = new Chart(
      place("duty"), [["x", "#ff8f8f"], ["y", "#8fe3a3"], ["z", "#8fb4ff"]], [0, 100]);
    this.headroom = new Chart(place("headroom"), [["headroom", "#6fe0b0"]], [0, 60]);
    this.lastNs = -Infinity;
  }

  add(status) {
    if (status.time_ns - this.lastNs < 1e9 / kPerSecond) return;
    this.lastNs = status.time_ns;
    const time = status.time_ns * 1e-9;
    const { sensor, model } = status.temperature_c;
    this.temperature.add(time, [sensor, model, ...this.marks]);
    this.current.add(time, [Math.hypot(...status.current_a), status.limit_a]);
    this.duty.add(time, status.duty.map((d) => 100 * Math.abs(d)));
    this.headroom.add(time, [status.headroom_s === null ? null : Math.min(status.headroom_s, 60)]);
  }
}
