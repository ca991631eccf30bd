// SPDX-License-Identifier: MIT
// session.mjs ADDRESS: every method of the protocol once, as a program in JavaScript calls it.
import assert from "node:assert/strict";
import { Ball, RequestError } from "../../../clients/js/src/node.js";

const knock = [
  { t_ms: 0, direction: "front", level: 1 },
  { t_ms: 60, level: 0 },
  { t_ms: 120, level: 0.6 },
  { t_ms: 180, level: 0 },
];

async function refusal(call) {
  try {
    await call;
  } catch (error) {
    if (error instanceof RequestError) return error.reason;
    throw error;
  }
  return "none";
}

/** What starts or ends is waited for, so that the order of the session's lines is always the same. */
async function skipTo(events, type) {
  for (;;) {
    const { value: event } = await events.next();
    if (event.type === type) return event;
  }
}

async function query(ball) {
  await ball.ping();
  await ball.describe();
  await ball.status();
  await ball.list();
  await ball.connectionList();
}

async function play(ball, events) {
  // The first `next` subscribes.
  const ended = skipTo(events, "effect_ended");
  await ball.pulse("left", { level: 0.6, duration_ms: 60 });
  await ended;
  await ball.vibrate([0, 1, 0.5], { frequency_hz: 40, slot: "engine", lease_ms: 10_000 });
  await skipTo(events, "effect_started");
  await ball.update({ slot: "engine", level: 0.3 });
  await ball.stop({ slot: "engine" });
  await skipTo(events, "effect_ended");
  await ball.hold({ azimuth_deg: 90, elevation_deg: 20 }, { current_a: 4, duration_ms: 80, priority: 7 });
  await skipTo(events, "effect_ended");
  const { effect } = await ball.circle("up", { speed_pins_s: 20, sense: "cw", duration_ms: 10_000 });
  await skipTo(events, "effect_started");
  await ball.stop({ effect });
  await skipTo(events, "effect_ended");
  ball.rumble("road", 0.4, "down", { frequency_hz: 60, lease_ms: 10_000 });
  await skipTo(events, "effect_started");
  ball.rumble("road", 0);
  await skipTo(events, "effect_ended");
  await ball.hold({ pin: 34 }, { lease_ms: 10_000 });
  await skipTo(events, "effect_started");
  await ball.stopAll();
  await skipTo(events, "effect_ended");
}

async function managePatterns(ball, events) {
  await ball.patternPut({ name: "acme/knock", description: "Two knocks.", keyframes: knock });
  await ball.patternList();
  await ball.patternGet({ name: "acme/knock" });
  await ball.play("acme/knock", { rotate_to: "right" });
  await skipTo(events, "effect_ended");
  await ball.play(undefined, { keyframes: knock, rate: 2 });
  await skipTo(events, "effect_ended");
  await ball.patternRemove({ name: "acme/knock" });
}

async function forecastEffects(ball) {
  await ball.preview({ method: "effect.pulse", params: { direction: "up", duration_ms: 20 } });
  await ball.thermalForecast({ current_a: 12, direction: "left" });
  await ball.latency();
}

async function watch(ball) {
  const telemetry = ball.telemetry(20, ["state", "temperature_c", "current_a", "orientation"]);
  await telemetry.next();
  await telemetry.return();
  await ball.call("telemetry.unsubscribe");
  await ball.telemetryHistory({ seconds: 10 });
  await ball.eventsHistory({ limit: 3 });
}

async function operate(ball, events) {
  await ball.claim({ lease_ms: 2000 });
  await ball.release();
  await ball.outputSetGain({ gain: 0.8 });
  await ball.outputSetGain({ gain: 1 });
  await ball.orientationRecenter({ azimuth_deg: -40 });
  assert.equal(await refusal(ball.orientationSet({ quaternion: { w: 1, x: 0, y: 0, z: 0 } })), "unsupported");
  await ball.simSet({ ambient_c: 24, fault: {} });
  await ball.simTruth();
  assert.equal(await refusal(ball.enterBootLoader()), "armed");
  await ball.emergencyStop();
  await skipTo(events, "state_changed");
  assert.equal(await refusal(ball.pulse("left")), "not_armed");
  await ball.arm();
  await skipTo(events, "state_changed");
}

async function provokeErrors(ball) {
  assert.equal(await refusal(ball.pulse("sideways")), "invalid_params");
  assert.equal(await refusal(ball.call("effect.rattle", { direction: "left" })), "method_not_found");
  assert.equal(await refusal(ball.stop({ slot: "nothing" })), "no_such_effect");
  assert.equal(await refusal(ball.play("hartbeat")), "no_such_pattern");
}

const ball = await Ball.connect({ address: process.argv[2], name: "session/javascript", timeoutMs: 60_000 });
await query(ball);
const events = ball.events(["effect_started", "effect_ended", "state_changed"]);
await play(ball, events);
await managePatterns(ball, events);
await forecastEffects(ball);
await watch(ball);
await operate(ball, events);
await provokeErrors(ball);
await ball.call("events.unsubscribe");
ball.close();
