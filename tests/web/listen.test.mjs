// SPDX-License-Identifier: MIT
// The onsets that the dashboard's listener finds, by the times at which its timer calls it. No browser: the sound is computed.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Listener } from "../../clients/dashboard/src/listen.js";

globalThis.AudioContext ??= class {};

/** Calls a listener every `everyS` of a sound of two channels, `sound(t)`: [left, right]; returns its pulses, with their times. */
function listen(sound, everyS, { seconds = 4, sampleRate = 48_000 } = {}) {
  const pulses = [];
  let now = 0;
  const link = { notify: (method, params) => method === "effect.pulse" && pulses.push({ at: now, ...params }) };
  const listener = new Listener(link, { strength: () => ({ current_a: 5, felt_a: 1 }), onPushes: () => {}, ended: () => {} });
  listener.begin();
  const side = (channel, size) => ({
    samples: new Float32Array(size),
    analyser: {
      getFloatTimeDomainData(samples) {
        const end = Math.round(now * sampleRate);
        samples.forEach((_, i) => { samples[i] = end - samples.length + i < 0 ? 0 : sound((end - samples.length + i) / sampleRate)[channel]; });
      },
    },
  });
  listener.analysers = { highpass: [side(0, 8192), side(1, 8192)], lowpass: [side(0, 2048), side(1, 2048)] };
  listener.vibrate = () => {};
  for (let call = 1; call * everyS <= seconds; ++call) {
    now = call * everyS;
    listener.context = { state: "running", sampleRate, currentTime: now };
    listener.poll();
  }
  return pulses;
}

const tone = (t) => 0.5 * Math.sin(2 * Math.PI * 2000 * t);
/** 10 ms of a tone, every `periodS`, on both sides. */
const clicks = (periodS) => (t) => (t % periodS > 0.105 && t % periodS < 0.115 ? [tone(t), tone(t)] : [0, 0]);

test("each of ten clicks is one push, however far apart the calls of the timer are up to 0.15 s", () => {
  for (const everyS of [0.01, 0.02, 0.033, 0.1, 0.15]) assert.equal(listen(clicks(0.4), everyS).length, 10, `${everyS} s`);
});

test("at 44.1 kHz, too", () => {
  assert.equal(listen(clicks(0.4), 0.1, { sampleRate: 44_100 }).length, 10);
});

test("what is longer ago than is kept is no push", () => {
  assert.ok(listen(clicks(0.4), 0.5).length < 10);
});

test("of several onsets in one call only the last pushes, on its side", () => {
  const first = (t) => t > 0.02 && t < 0.03;
  const second = (t) => t > 0.1 && t < 0.11;
  const pulses = listen((t) => [first(t) ? tone(t) : 0, second(t) ? tone(t) : 0], 0.15, { seconds: 0.15 });
  assert.deepEqual(pulses.map(({ direction }) => direction.azimuth_deg), [-90]);
});

test("pushes are 60 ms apart at least", () => {
  const pulses = listen((t) => [t % 0.03 < 0.005 ? tone(t) : 0, 0], 0.02, { seconds: 2 });
  assert.ok(pulses.length > 0);
  pulses.slice(1).forEach(({ at }, i) => assert.ok(at - pulses[i].at > 0.0599, `${at}`));
});

test("a tone that goes on pushes at its beginning only, as strong as it is", () => {
  const pulses = listen((t) => (t > 1 ? [tone(t), tone(t)] : [0, 0]), 0.02);
  assert.equal(pulses.length, 1);
  assert.ok(Math.abs(pulses[0].gain - (0.2 + 0.8 * 0.5)) < 0.01, `${pulses[0].gain}`);
  assert.equal(pulses[0].direction.azimuth_deg, 0);
});
