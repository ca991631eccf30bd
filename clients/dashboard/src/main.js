// SPDX-License-Identifier: MIT
// The dashboard: puts the pieces together and keeps the page true.
import { Ball } from "./ball.js";
import { Charts } from "./charts.js";
import { Gain } from "./gain.js";
import { eventList } from "./event_list.js";
import { Link } from "./link.js";
import { Pad } from "./pad.js";
import { Simulator } from "./simulator.js";
import { StateCard } from "./state.js";
import { stopButton } from "./stop.js";
import { askForToken } from "./token.js";
import { watch } from "./watch.js";
import { amperes, errorMessage, counted, degrees, isHeatKnown, lasting, whither } from "./words.js";

const kTelemetry = {
  rate_hz: 25,
  fields: ["state", "reason", "since_s", "remedy", "temperature_c", "limit_a", "headroom_s", "burst_s", "derating",
    "current_a", "duty", "field", "force_n", "pin", "fan", "orientation", "effects", "loop", "link", "last_trip", "pins"],
};
const $ = (id) => document.getElementById(id);

function showMessage(text, bad = false) {
  $("said").textContent = text;
  $("said").classList.toggle("bad", bad);
}

const link = new Link("dashboard", [
  { method: "telemetry.subscribe", params: kTelemetry },
  { method: "events.subscribe", params: { scope: "all" } },
]);
const ball = new Ball($("ball"));
const pad = new Pad($("pad"), link, showMessage);
const simulator = new Simulator($("simulator"), link, ball, showMessage);
const card = new StateCard($("arm"));
const gain = new Gain($("gain"), link, showMessage);
let charts = null;
let limits = { current_a: 15 };
watch(link);
askForToken(link);
eventList($("happened"), link, showMessage);
stopButton(link, showMessage);

function begin({ detail: { hello, device } }) {
  limits = hello.limits;
  $("device").textContent = hello.device.name;
  $("simulated").hidden = !hello.device.simulated;
  $("version").textContent = `hedgehogd ${hello.version}, protocol ${hello.protocol}, role ${hello.role}`;
  $("most").textContent = amperes(limits.current_a);
  pad.allow(hello);
  simulator.allow(hello);
  card.describe(hello, device);
  ball.setPins(device.pins);
  // An older daemon keeps none.
  Promise.all([600, 120].map((span) => link.call("telemetry.history", { seconds: span }))).catch(() => [])
    .then((histories) => { charts = new Charts($("charts"), device.limits, histories); });
  gain.describe(hello, device);
}
link.addEventListener("open", begin);

function showNumbers(status) {
  const flows = Math.hypot(...status.current_a);
  const known = isHeatKnown(status.temperature_c);
  $("temperature").textContent = degrees(status.temperature_c.model);
  $("current").textContent = `${amperes(flows)} of ${amperes(status.limit_a)}`;
  $("duty").textContent = status.duty.map((d) => `${(100 * Math.abs(d)).toFixed(0)} %`).join(" · ");
  $("headroom").textContent = lasting(status.headroom_s, known);
  $("burst").textContent = lasting(status.burst_s, known, 1);
  const fan = status.fan;
  $("fan").textContent = fan.speed_rpm === null ? "–" : `${Math.round(fan.speed_rpm)} rpm`;
  const late = status.loop.lateness_us;
  $("loop").textContent = `${status.loop.rate_hz.toFixed(0)} Hz, late ${late.p50.toFixed(0)} µs, p99 ${late.p99.toFixed(0)} µs, most ${(late.max / 1000).toFixed(1)} ms`;
  $("ticks").textContent = `${counted(status.loop.ticks, "tick")}, ${status.loop.skipped.toLocaleString("en")} skipped`;
  $("frames").textContent = `${counted(status.link.frames_out, "frame")}, ${status.link.lost} lost, ${status.link.errors} bad`;
  $("caption").textContent = status.pin === null
    ? "At rest" : `Pushes ${whither(status.field)}: ${amperes(flows)}, ${(1000 * status.force_n).toFixed(0)} mN at pin ${status.pin}`;
}

let shownEffects = "";
function showEffects(effects) {
  const rows = effects.map((e) => [
    e.method.replace("effect.", ""), e.slot ?? "", e.client ?? `connection ${e.connection}`,
    e.playing ? amperes(e.current_a) : "waits", `${(e.remaining_ms / 1000).toFixed(1)} s`,
  ]);
  const text = JSON.stringify(rows);
  if (text === shownEffects) return;
  shownEffects = text;
  $("no-effects").hidden = rows.length > 0;
  $("effects-table").hidden = rows.length === 0;
  $("effects").replaceChildren(...rows.map((cells) => {
    const row = document.createElement("tr");
    row.append(...cells.map((cell) => Object.assign(document.createElement("td"), { textContent: cell })));
    return row;
  }));
}

link.addEventListener("telemetry", ({ detail: status }) => {
  ball.setExtensions(status.pins.extension_mm);
  const flows = Math.hypot(...status.current_a);
  ball.setField(status.field, Math.min(1, flows / limits.current_a));
  if (status.orientation) ball.setOrientation(status.orientation.quaternion);
  card.show(status);
  pad.set({ state: status.state });
  showNumbers(status);
  showEffects(status.effects);
  charts?.add(status);
});

ball.addEventListener("pin", ({ detail: pin }) => pad.play({ pin }));

$("arm").addEventListener("click", () =>
  link.call("device.arm").then(() => showMessage("armed"), (error) => showMessage(errorMessage(error), true)));

// For tests: what is drawn, as numbers.
window.dashboard = { ball, link, charts: () => charts };
