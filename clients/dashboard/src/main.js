// SPDX-License-Identifier: MIT
// The dashboard: puts the pieces together and keeps the page true.
import { Ball } from "./ball.js";
import { Charts } from "./charts.js";
import { happened } from "./happened.js";
import { Link } from "./link.js";
import { Pad } from "./pad.js";
import { Simulator } from "./simulator.js";
import { stopButton } from "./stop.js";
import { watch } from "./watch.js";
import { amperes, contradiction, degrees, kStates, reason, seconds, whither } from "./words.js";

const kTelemetry = {
  rate_hz: 25,
  fields: ["state", "reason", "since_s", "remedy", "temperature_c", "limit_a", "headroom_s", "burst_s", "derating",
    "current_a", "duty", "field", "force_n", "pin", "fan", "orientation", "effects", "loop", "link", "last_trip", "pins"],
};
const $ = (id) => document.getElementById(id);

function say(text, bad = false) {
  $("said").textContent = text;
  $("said").classList.toggle("bad", bad);
}

const link = new Link("dashboard", [
  { method: "telemetry.subscribe", params: kTelemetry },
  { method: "events.subscribe", params: { scope: "all" } },
]);
const ball = new Ball($("ball"));
const pad = new Pad($("pad"), link, say);
const simulator = new Simulator($("simulator"), link, ball, say);
let charts = null;
let limits = { current_a: 15 };
watch(link);
happened($("happened"), link);
stopButton(link, say);

function begin({ detail: { hello, device } }) {
  limits = hello.limits;
  $("device").textContent = hello.device.name;
  $("simulated").hidden = !hello.device.simulated;
  $("version").textContent = `hedgehogd ${hello.version}, protocol ${hello.protocol}, role ${hello.role}`;
  $("most").textContent = amperes(limits.current_a);
  pad.allow(hello);
  simulator.allow(hello);
  $("arm").dataset.may = hello.role === "operate";
  ball.setPins(device.pins);
  charts = new Charts($("charts"), device.limits);
}
link.addEventListener("open", begin);

function showState(status) {
  const { state } = status;
  document.body.dataset.state = state;
  $("state").textContent = status.derating ? "Armed, derated" : kStates[state];
  $("why").textContent = state === "armed" ? (status.derating ? "Less current than asked, until it has cooled." : "") : reason(status.reason);
  $("remedy").textContent = status.remedy ? `${status.remedy}.` : "";
  $("arm").hidden = $("arm").dataset.may !== "true" || !["disarmed", "tripped"].includes(state);
  const trip = status.last_trip;
  $("trip").textContent = trip ? `Last trip: ${[reason(trip.reason), contradiction(trip.disagreement)].filter(Boolean).join(" ")}` : "";
}

function showNumbers(status) {
  const flows = Math.hypot(...status.current_a);
  const t = status.temperature_c;
  $("temperature").textContent = `${degrees(t.sensor)} · model ${degrees(t.model)}${t.upper === undefined ? "" : `, at most ${degrees(t.upper)}`}${t.skin === undefined ? "" : ` · skin at most ${degrees(t.skin)}`}`;
  $("current").textContent = `${amperes(flows)} of ${amperes(status.limit_a)}`;
  $("duty").textContent = status.duty.map((d) => `${(100 * Math.abs(d)).toFixed(0)} %`).join(" · ");
  $("headroom").textContent = seconds(status.headroom_s);
  $("burst").textContent = status.burst_s === null ? "for ever" : `${status.burst_s.toFixed(1)} s`;
  const fan = status.fan;
  $("fan").textContent = fan.speed_rpm === null ? "–" : `${Math.round(fan.speed_rpm)} rpm`;
  const late = status.loop.lateness_us;
  $("loop").textContent = `${status.loop.rate_hz.toFixed(0)} Hz, late ${late.p50.toFixed(0)} µs, p99 ${late.p99.toFixed(0)} µs, most ${(late.max / 1000).toFixed(1)} ms`;
  $("ticks").textContent = `${status.loop.ticks.toLocaleString("en")} ticks, ${status.loop.skipped.toLocaleString("en")} skipped`;
  $("frames").textContent = `${status.link.frames_out.toLocaleString("en")} frames, ${status.link.lost} lost, ${status.link.errors} bad`;
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
  showState(status);
  showNumbers(status);
  showEffects(status.effects);
  charts?.add(status);
});

ball.addEventListener("pin", ({ detail: pin }) => pad.play({ pin }));

$("arm").addEventListener("click", () =>
  link.call("device.arm").then(() => say("armed"), (error) => say(error.message, true)));

// For tests: what is drawn, as numbers.
window.dashboard = { ball, link };
