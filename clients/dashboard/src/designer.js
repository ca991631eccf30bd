// SPDX-License-Identifier: MIT
// The designer: key frames put on the ball over time, shown as the currents that would flow, played, saved and loaded.
import { Audition } from "./audition.js";
import { Ball } from "./ball.js";
import { FrameTable } from "./frame_table.js";
import { Keyframes, kMaxMs } from "./keyframes.js";
import { Link } from "./link.js";
import { Listener } from "./listen.js";
import { Path } from "./path.js";
import { PathEditor } from "./path_editor.js";
import { stopButton } from "./stop.js";
import { askForToken } from "./token.js";
import { watch } from "./watch.js";
import { amperes, errorMessage, counted, degrees, limitation, waveWords, whither } from "./words.js";

const kPreviewMs = 250;
const kDragLeaseMs = 250;
const kHeight = 160;
const $ = (id) => document.getElementById(id);

function showMessage(text, bad = false) {
  $("said").textContent = text;
  $("said").classList.toggle("bad", bad);
}

const link = new Link("designer page", [
  { method: "telemetry.subscribe", params: { rate_hz: 25, fields: ["state", "current_a", "field", "pins"] } },
]);
const ball = new Ball($("ball"));
const path = new Path(ball);
const audition = new Audition();
watch(link);
askForToken(link);
stopButton(link, showMessage);
const form = $("design");
form.addEventListener("submit", (event) => event.preventDefault());
let frames = new Keyframes();
/** The time of the key frame that is chosen, of which there is one at most; null: none. */
let chosenAt = null;
let limits = { current_a: 15, felt_a: 2.1 };
/** A drag that is recorded: {from, points}. */
let drag = null;

const number = (name) => Number(form.elements[name].value);
const span = () => number("span");
const chosen = () => frames.frames.findIndex(({ t }) => t === chosenAt);
const ask = async (method, params, done) => {
  try {
    done(await link.call(method, params));
  } catch (error) {
    showMessage(errorMessage(error), true);
  }
};

const table = new FrameTable($("frames"), {
  change: (index, frame) => edit(() => {
    frames.remove(index);
    frames.put(frame);
  }),
  remove: (index) => remove(index),
});

/** Carries out a change of the key frames and shows it; `tabled` false: not in the table, which is slow to fill. */
function edit(change, tabled = true) {
  try {
    change();
    showMessage("");
  } catch (error) {
    showMessage(errorMessage(error), true);
  }
  $("no-frames").hidden = frames.frames.length > 0;
  if (tabled) table.show(frames.frames, chosen());
  while (span() < frames.length()) form.elements.span.selectedIndex += 1;
  const wave = waveWords(frames.wave());
  $("wave").hidden = wave === "";
  $("wave").textContent = `Modulated as in the file: ${wave}`;
  draw();
  clearTimeout(edit.timer);
  edit.timer = setTimeout(forecast, kPreviewMs);
}

function line(id, points) {
  const place = ([t, share]) => `${((1000 * t) / span()).toFixed(1)},${(kHeight * (1 - 0.94 * share)).toFixed(1)}`;
  $(id).setAttribute("points", points.map(place).join(" "));
}

function draw() {
  form.elements.time.max = span();
  const now = chosen() < 0 ? number("time") : chosenAt;
  $("time-shown").value = `${(now / 1000).toFixed(2)} s`;
  $("level-shown").value = number("level").toFixed(2);
  $("strength-shown").value = amperes(number("strength"));
  for (const end of ["x1", "x2"]) $("now").setAttribute(end, (1000 * now) / span());
  line("levels", frames.frames.map(({ t, level }) => [t, level]));
  const at = frames.at(now);
  path.show(frames, chosen());
  ball.setField(at && at.level > 0 ? at.direction : [0, 0, 0], at?.level ?? 0);
  const which = chosen() < 0 ? "At" : `Key frame ${chosen() + 1} of ${frames.frames.length}, at`;
  $("caption").textContent = at ? `${which} ${(now / 1000).toFixed(2)} s towards ${whither(at.direction)}, level ${at.level.toFixed(2)}` : "At rest";
}

const params = () => ({ ...frames.wave(), keyframes: frames.wire(), current_a: number("strength") });

/** What the forecast of `frames` sounds like. */
function soundOf({ current_a, step_ms }) {
  const steps = current_a.map((current, i) => ({
    level: Math.min(1, Math.hypot(...current) / number("strength")),
    // The ball's y is left.
    side: -(frames.at((i + 0.5) * step_ms)?.direction[1] ?? 0),
  }));
  return { steps, stepS: step_ms / 1000, wave: frames.wave() };
}

async function forecast() {
  clearTimeout(edit.timer);
  line("currents", []);
  $("forecast").textContent = "";
  const wanted = frames.playable() ? JSON.stringify(params()) : "";
  audition.endOthers(wanted);
  if (wanted === "" || !link.ready) return;
  const requested = frames.frames;
  await ask("effect.preview", { method: "effect.play", params: params() }, (preview) => {
    if (requested !== frames.frames) return;
    const sound = soundOf(preview);
    line("currents", sound.steps.map(({ level }, i) => [(i + 0.5) * preview.step_ms, level]));
    audition.play(wanted, sound);
    const limited = limitation(preview.limited_by);
    $("forecast").textContent =
      `at most ${amperes(preview.peak_current_a)}, ${degrees(preview.peak_temperature_c)}${limited}`;
  });
}

form.addEventListener("input", (event) => {
  const { name } = event.target;
  if (name === "time") chosenAt = null;
  if (name === "level" && chosen() >= 0) edit(() => frames.put({ ...frames.frames[chosen()], level: number("level") }));
  else if (["time", "level", "strength", "span"].includes(name)) edit(() => {});
});
$("add").addEventListener("click", () => edit(() => {
  const direction = frames.at(number("time"))?.direction ?? frames.frames.at(-1)?.direction ?? [1, 0, 0];
  frames.put({ t: number("time"), direction, level: number("level") });
}));
$("clear").addEventListener("click", () => edit(() => { frames = new Keyframes(); }));

$("play").addEventListener("click", () => {
  if (!frames.playable()) return showMessage("Put two key frames first: the last one is the end.", true);
  return ask("effect.play", { ...params(), slot: "designer" }, (admission) => showMessage(
    `plays with ${amperes(admission.current_a)}${limitation(admission.limited_by)}`));
});

$("hear").addEventListener("click", async () => {
  const on = $("hear").getAttribute("aria-pressed") !== "true";
  $("hear").setAttribute("aria-pressed", on);
  await audition.enable(on);
  if (on) await forecast();
});

/** Chooses a key frame, or none with -1: the sliders have its time and level. */
function choose(index) {
  const frame = frames.frames[index];
  chosenAt = frame?.t ?? null;
  if (frame) {
    form.elements.time.value = frame.t;
    form.elements.level.value = frame.level;
  }
  edit(() => {});
}
const remove = (index) => edit(() => frames.remove(index));
new PathEditor(ball, path, {
  busy: () => $("record").getAttribute("aria-pressed") === "true",
  choose,
  move: (index, direction) => edit(() => frames.put({ ...frames.frames[index], direction }), false),
  moved: () => edit(() => {}),
  put: (direction) => edit(() => {
    chosenAt = null;
    frames.put({ t: number("time"), direction, level: number("level") });
  }),
});
addEventListener("keydown", (event) => {
  const typing = event.target.closest?.("input:not([type=range]), select, textarea");
  if (!["Delete", "Backspace"].includes(event.key) || typing || chosen() < 0) return;
  event.preventDefault();
  remove(chosen());
});

// A drag, while recording, is many key frames.
function recording(on) {
  $("record").setAttribute("aria-pressed", on);
  $("record").textContent = on ? "Drag on the ball now" : "Record a drag";
  ball.orbit.enableRotate = !on;
}
$("record").addEventListener("click", () => recording($("record").getAttribute("aria-pressed") !== "true"));
$("ball").addEventListener("pointerdown", (event) => {
  const direction = path.directionAt(event);
  if ($("record").getAttribute("aria-pressed") !== "true" || !direction) return;
  $("ball").setPointerCapture(event.pointerId);
  drag = { from: performance.now(), points: [{ t: 0, direction }] };
  link.notify("effect.hold", { slot: "drag", direction, current_a: number("strength") * number("level"), lease_ms: kDragLeaseMs });
});
$("ball").addEventListener("pointermove", (event) => {
  const direction = drag && path.directionAt(event);
  if (!direction) return;
  const t = Math.round(performance.now() - drag.from);
  if (t > kMaxMs || t <= drag.points.at(-1).t) return;
  drag.points.push({ t, direction });
  link.notify("effect.update", { slot: "drag", direction });
});
function endDrag() {
  if (!drag) return undefined;
  const { points } = drag;
  drag = null;
  link.notify("effect.stop", { slot: "drag" });
  recording(false);
  if (points.length < 2) return showMessage("Nothing was recorded: the pointer did not move on the ball.", true);
  edit(() => {
    chosenAt = null;
    frames = Keyframes.drawn(points, number("level"));
  });
  return showMessage(`${(frames.length() / 1000).toFixed(1)} s as ${counted(frames.frames.length, "key frame")}`);
}
for (const ending of ["pointerup", "pointercancel", "blur", "pagehide"]) addEventListener(ending, endDrag);
// A hand that rests while it drags still holds.
setInterval(() => {
  if (drag && performance.now() - drag.from > kMaxMs) endDrag();
  if (drag) link.notify("effect.update", { slot: "drag" });
}, kDragLeaseMs / 2);

const pattern = () => frames.pattern(form.elements.name.value);
$("save").addEventListener("click", () => {
  if (!frames.playable()) return showMessage("There is nothing to save yet.", true);
  const url = URL.createObjectURL(new Blob([`${JSON.stringify(pattern(), null, 2)}\n`], { type: "application/json" }));
  const file = `${form.elements.name.value.split("/").at(-1) || "pattern"}.json`;
  Object.assign(document.createElement("a"), { href: url, download: file }).click();
  URL.revokeObjectURL(url);
  return showMessage(`${file}: hedgehogctl play ${file}`);
});
$("keep").addEventListener("click", () => {
  if (!frames.playable()) return showMessage("There is nothing to keep yet.", true);
  return ask("pattern.put", pattern(), ({ name }) => showMessage(`${name} is stored in the daemon`));
});
$("load").addEventListener("change", async () => {
  const [file] = $("load").files;
  if (!file) return;
  const text = await file.text();
  $("load").value = "";
  let moved = 0;
  edit(() => {
    frames = Keyframes.read(text, ball.pins.map(({ number: pin, direction }) => ({ number: pin, direction: direction.toArray() })));
    form.elements.name.value = frames.members.name ?? form.elements.name.value;
    moved = frames.moved;
  });
  if (moved > 0) showMessage(`${counted(moved, "key frame")} moved by 1 ms: others are at its time`);
});

const listener = new Listener(link, {
  strength: () => ({ current_a: number("strength"), felt_a: limits.felt_a }),
  onPushes: (pushes) => { $("heard").textContent = `${pushes} ${pushes === 1 ? "push" : "pushes"}`; },
  ended: () => listening(false),
});
function listening(on) {
  $("silence").disabled = !on;
  $("microphone").setAttribute("aria-pressed", on && listener.stream != null);
}
async function listen(start) {
  try {
    await start();
    $("heard").textContent = "listening";
    listening(true);
  } catch (error) {
    await listener.stop();
    $("heard").textContent = `No sound: ${error.message}`;
    listening(false);
  }
}
$("microphone").addEventListener("click", () => listen(() => listener.startMicrophone()));
$("sound").addEventListener("change", () => {
  const [file] = $("sound").files;
  if (file) listen(() => listener.startFile(file));
});
$("silence").addEventListener("click", () => listener.stop().then(() => listening(false)));

link.addEventListener("open", ({ detail: { hello, device } }) => {
  limits = hello.limits;
  form.elements.strength.max = limits.current_a;
  $("simulated").hidden = !hello.device.simulated;
  ball.setPins(device.pins);
  edit(() => {});
});
link.addEventListener("telemetry", ({ detail: status }) => {
  document.body.dataset.state = status.state;
  ball.setExtensions(status.pins.extension_mm);
});
draw();

window.dashboard = { ball, path, link, listener, audition, frames: () => frames.frames };
