// SPDX-License-Identifier: MIT
// The numbers and words around the picture.

const kSpeedUnit = 3.6; // km/h in a m/s
const $ = (id) => document.getElementById(id);

function put(id, text) {
  const element = $(id);
  if (element.textContent !== text) element.textContent = text;
}

export function clock(s) {
  if (s === null || s === undefined) return "–";
  // Rounded before it is divided: 179.96 s are three minutes.
  const tenths = Math.round(10 * s);
  return `${Math.floor(tenths / 600)}:${((tenths % 600) / 10).toFixed(1).padStart(4, "0")}`;
}

export function showScene(scene) {
  put("speed", Math.abs(kSpeedUnit * scene.speed_mps).toFixed(0));
  put("lap", String(scene.lap));
  put("time", clock(scene.lap_s));
  put("last", clock(scene.last_s));
  put("best", clock(scene.best_s));
  document.body.dataset.mode = scene.mode;
  const chosen = document.querySelector(`[name=mode][value=${scene.mode}]`);
  if (chosen && !chosen.checked) chosen.checked = true;
  $("pause").setAttribute("aria-pressed", scene.paused);
  $("paused").hidden = !scene.paused;
}

let gone = 0;
/** For three seconds. */
export function showLap({ lap, time_s: time, best, driver }) {
  put("lapdone", `Lap ${lap}: ${clock(time)}${best ? ", your best" : ""}${driver ? ", by the driver" : ""}`);
  clearTimeout(gone);
  gone = setTimeout(() => put("lapdone", ""), 3000);
}

function warmth(ball) {
  if (ball.budget > 0.6) return "cool";
  return ball.budget > 0.25 ? "warm" : "hot";
}

function strengthInWords(ball) {
  if (ball.temperature_c === null) return ball.reason || "The ball's temperature is not known.";
  const now = `the ball is ${warmth(ball)}, ${ball.temperature_c.toFixed(0)} °C`;
  if (ball.state !== "armed" || ball.reason) return `Not felt now; ${now}`;
  const full = ball.gain > 0.995 ? "Full strength" : `Strength ${Math.round(100 * ball.gain)} %`;
  const derated = ball.derated ? ", derated" : "";
  return `${full}: ${now}${derated}`;
}

function help(ball) {
  if (!ball.connected) return "Driving works without one. make run starts a simulated ball.";
  if (ball.reason) return ball.reason;
  if (!ball.simulated) return "";
  const link = document.createElement("a");
  link.href = `http://${location.hostname}:7587/orientation.html`;
  link.target = "_blank";
  link.rel = "noreferrer";
  link.textContent = "Turn the simulated ball";
  return [link, " with a mouse or a phone, and drive by it."];
}

let shown = "";
export function showBall(ball) {
  document.body.dataset.ball = ball.connected ? ball.state : "none";
  const budget = $("budget");
  const left = Math.round(100 * (ball.budget ?? 0));
  budget.setAttribute("aria-valuenow", left);
  budget.dataset.level = warmth(ball);
  budget.firstElementChild.style.width = `${left}%`;
  put("strength", ball.connected ? strengthInWords(ball) : "No ball: what would be felt is only shown.");
  const key = `${ball.connected} ${ball.state} ${ball.simulated} ${ball.reason}`;
  if (key === shown) return;
  shown = key;
  $("help").replaceChildren(...[help(ball)].flat());
}
