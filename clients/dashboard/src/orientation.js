// SPDX-License-Identifier: MIT
// The orientation indicator: the daemon keeps the push on top (a world-frame effect, renewed by lease); a
// mouse, keys or a phone turn the ball, simulated or fed from outside (imu.type "external").
import { Quaternion, Vector3 } from "three";

import { Ball } from "./ball.js";
import { Link } from "./link.js";
import { stopButton } from "./stop.js";
import { askForToken } from "./token.js";
import { watch } from "./watch.js";
import { amperes, errorMessage, reason, whither } from "./words.js";

const kLeaseMs = 1000;
const kRenewMs = 300;
const kFeedMs = 25;
/** As old as the daemon lets a world-frame effect play on. */
const kStaleMs = 100;
/** Ends of a push that this page would have renewed: up was not known, or the page was held up. */
const kLapses = ["expired", "preempted", "orientation_lost"];
const kStyles = {
  pulse: ["effect.vibrate", { waveform: "square", frequency_hz: 2, on_fraction: 0.15, current_a: 12 }],
  steady: ["effect.hold", { current_a: 5 }],
};
const $ = (id) => document.getElementById(id);

function showMessage(text, bad = false) {
  $("said").textContent = text;
  $("said").classList.toggle("bad", bad);
}

const link = new Link("orientation page", [
  { method: "telemetry.subscribe",
    params: { rate_hz: 25, fields: ["state", "reason", "remedy", "current_a", "field", "pin", "orientation", "pins"] } },
  { method: "events.subscribe", params: { types: ["effect_ended"] } },
]);
const ball = new Ball($("ball"));
ball.showUp();
watch(link);
askForToken(link);
stopButton(link, showMessage);
let simulated = false;
let most = 15;
let feed = null;
let indicating = false;
/** The push as the daemon numbers it. */
let effect = null;
let lapsed = false;

link.addEventListener("open", ({ detail: { hello, device } }) => {
  simulated = hello.device.simulated && hello.role === "operate";
  most = hello.limits.current_a;
  $("simulated").hidden = !hello.device.simulated;
  ball.setTurning(simulated);
  ball.setPins(device.pins);
  if (indicating) start();
});

link.addEventListener("telemetry", ({ detail: status }) => {
  document.body.dataset.state = status.state;
  ball.setExtensions(status.pins.extension_mm);
  const flows = Math.hypot(...status.current_a);
  ball.setField(status.field, Math.min(1, flows / most));
  if (status.orientation && !feed) ball.setOrientation(status.orientation.quaternion);
  const up = status.orientation ? whither(status.orientation.up) : null;
  $("caption").textContent = status.state !== "armed"
    ? `${reason(status.reason)} ${status.remedy ?? ""}`
    : !up ? "No orientation sensor: the direction of up is unknown."
    : `Up in the room is the ball's ${up}${flows > 0.2 ? `; pushes there with ${amperes(flows)}` : ""}`;
  if (lapsed && status.state !== "armed") over("The coils are off");
  if (lapsed && status.orientation?.age_ms <= kStaleMs) start();
});

function over(why) {
  show(false);
  showMessage(`${why}; up is no longer shown.`, true);
}
link.addEventListener("event", ({ detail: { type, effect: ended, reason: why } }) => {
  if (type !== "effect_ended" || ended !== effect || !indicating) return;
  effect = null;
  lapsed = kLapses.includes(why);
  if (!lapsed) over(why === "tripped" ? "The coils are off" : `The push was ${why}`);
  else if (why === "orientation_lost") showMessage("Which way is up is not known; the push comes back when it is.");
});

function request(quaternion) {
  const q = { w: quaternion.w, x: quaternion.x, y: quaternion.y, z: quaternion.z };
  return simulated ? ["sim.set", { orientation: q }] : ["orientation.set", { quaternion: q }];
}

let sentAt = 0;
function send(quaternion) {
  if (performance.now() - sentAt < kFeedMs) return;
  sentAt = performance.now();
  link.notify(...request(quaternion));
}
ball.addEventListener("turn", ({ detail }) => {
  sentAt = 0;
  send(detail);
});

async function start() {
  effect = null;
  lapsed = false;
  const [method, own] = kStyles[document.querySelector("[name=style]:checked").value];
  try {
    const begun = await link.call(method, { ...own, slot: "up", direction: "up", frame: "world", lease_ms: kLeaseMs });
    effect = begun.effect;
    showMessage("");
  } catch (error) {
    showMessage(errorMessage(error), true);
    show(false);
  }
}

function show(on) {
  indicating = on;
  lapsed = false;
  $("indicate").setAttribute("aria-pressed", on);
  $("indicate").textContent = on ? "Stop showing" : "Show up";
}

setInterval(() => {
  if (indicating) link.notify("effect.update", { slot: "up" });
}, kRenewMs);
$("indicate").addEventListener("click", () => {
  show(!indicating);
  if (indicating) start();
  else link.notify("effect.stop", { slot: "up" });
});
for (const radio of document.querySelectorAll("[name=style]")) {
  radio.addEventListener("change", () => indicating && start());
}
$("recenter").addEventListener("click", () =>
  link.call("orientation.recenter").then(() => showMessage("front is where it points now"), (error) => showMessage(errorMessage(error), true)));

const kStep = Math.PI / 24;
const kKeys = { ArrowLeft: [-kStep, 0], ArrowRight: [kStep, 0], ArrowUp: [0, -kStep], ArrowDown: [0, kStep] };
addEventListener("keydown", (event) => {
  if (!simulated || !kKeys[event.key] || event.target.closest?.("input")) return;
  event.preventDefault();
  ball.turnBy(...kKeys[event.key]);
});

/**
 * W3C DeviceOrientation angles, degrees, to the protocol's quaternion: the phone's top is the ball's front,
 * its screen looks up.
 */
export function quaternionOf(alpha, beta, gamma) {
  const about = (x, y, z, degrees) => new Quaternion().setFromAxisAngle(new Vector3(x, y, z), (degrees * Math.PI) / 180);
  return about(0, 0, 1, alpha).multiply(about(1, 0, 0, beta)).multiply(about(0, 1, 0, gamma)).multiply(about(0, 0, 1, 90));
}

let asking = false;
async function turned(event) {
  if (event.alpha === null) {
    if (!feed && !asking) $("sensor").textContent = "This device has no orientation sensor.";
    return;
  }
  if (!link.ready || asking) return;
  const front = feed ?? quaternionOf(event.alpha, 0, 0).invert();
  const quaternion = front.clone().multiply(quaternionOf(event.alpha, event.beta, event.gamma));
  if (!feed) {
    // The first is answered: the daemon may take no orientation, or somebody else's.
    asking = true;
    try {
      await link.call(...request(quaternion));
    } catch (error) {
      removeEventListener("deviceorientation", turned);
      $("sensor").textContent = errorMessage(error);
      return;
    } finally {
      asking = false;
    }
    feed = front;
    $("sensor").textContent = "The phone turns the ball.";
  }
  ball.body.quaternion.copy(quaternion);
  ball.draw();
  send(quaternion);
}
link.addEventListener("gone", () => { feed = null; });
$("phone").addEventListener("click", async () => {
  if (!isSecureContext) {
    $("sensor").textContent = "The browser provides the orientation to pages on localhost only.";
    return;
  }
  const permission = await window.DeviceOrientationEvent?.requestPermission?.();
  if (permission === "denied") {
    $("sensor").textContent = "The browser does not allow it.";
    return;
  }
  $("sensor").textContent = "Waiting for the sensor …";
  addEventListener("deviceorientation", turned);
});

window.dashboard = { ball, link, quaternionOf };
