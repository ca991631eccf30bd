// SPDX-License-Identifier: MIT
// Editing of key frames in the designer; no browser, no daemon.
import assert from "node:assert/strict";
import { test } from "node:test";

import { angles, between, Keyframes, vector } from "../../clients/dashboard/src/keyframes.js";

const off = (a, b) => (Math.acos(Math.min(1, a.reduce((sum, c, i) => sum + c * b[i], 0))) * 180) / Math.PI;

test("key frames stay in order, and one replaces that of its time", () => {
  const frames = new Keyframes();
  frames.put({ t: 500, direction: [0, 2, 0], level: 1 });
  assert.equal(frames.put({ t: 0, direction: [1, 0, 0], level: 0.5 }), 0);
  frames.put({ t: 500, direction: [0, 0, 3], level: 2, ease: "smooth" });
  assert.deepEqual(frames.wire(), [
    { t_ms: 0, direction: [1, 0, 0], level: 0.5 }, { t_ms: 500, direction: [0, 0, 1], level: 1, ease: "smooth" }]);
  assert.equal(frames.length(), 500);
});

test("between two key frames it goes along the great circle, with their ease; beyond them it rests", () => {
  const frames = new Keyframes();
  frames.put({ t: 100, direction: [1, 0, 0], level: 0 });
  frames.put({ t: 300, direction: [0, 1, 0], level: 1 });
  assert.equal(frames.at(99), null);
  assert.equal(frames.at(301), null);
  assert.ok(off(frames.at(200).direction, vector(45, 0)) < 1e-4);
  assert.equal(frames.at(200).level, 0.5);
  frames.put({ ...frames.frames[0], ease: "step" });
  assert.equal(frames.at(299).level, 0);
  assert.ok(off(between([1, 0, 0], [-1, 0, 0], 0.5), [0, 0, 1]) < 1e-4, "opposite ones over the top");
});

test("angles are those of the protocol", () => {
  assert.deepEqual(angles(vector(90, 20)), { azimuth: 90, elevation: 20 });
  assert.ok(off(vector(90, 0), [0, 1, 0]) < 1e-4);
});

test("a written file is read back, and other directions of the protocol too", () => {
  const read = Keyframes.read(JSON.stringify({ keyframes: [{ t_ms: 0, level: 1, direction: "left" },
    { t_ms: 100, level: 0.5 }, { t_ms: 100, level: 0 }, { t_ms: 200, level: 1, direction: { azimuth_deg: -90 } },
    { t_ms: 300, level: 0, direction: { pin: 7 } }] }), [{ number: 7, direction: [0, 0, 1] }]);
  assert.deepEqual(read.frames.map(({ t }) => t), [0, 100, 101, 200, 300]);
  assert.deepEqual(read.frames[1].direction, [0, 1, 0]);
  assert.ok(off(read.frames[3].direction, [0, -1, 0]) < 1e-4);
  assert.deepEqual(read.frames[4].direction, [0, 0, 1]);
  assert.deepEqual(Keyframes.read(JSON.stringify({ keyframes: read.wire() })).wire(), read.wire());
});

const errorOf = (value) => {
  try {
    Keyframes.read(typeof value === "string" ? value : JSON.stringify(value));
    return "nothing";
  } catch ({ message }) {
    return message;
  }
};

test("a file's other members are kept, and its wave is played", () => {
  const file = { name: "acme/purr", description: "A cat.", waveform: "sine", frequency_hz: 25, licence: "MIT",
    keyframes: [{ t_ms: 0, direction: [1, 0, 0], level: 1 }, { t_ms: 100, direction: [1, 0, 0], level: 0 }] };
  const read = Keyframes.read(JSON.stringify({ ...file, duration_ms: 100, shipped: false }));
  assert.deepEqual(read.wave(), { waveform: "sine", frequency_hz: 25 });
  read.put({ t: 100, direction: [1, 0, 0], level: 0.5 });
  file.keyframes[1].level = 0.5;
  assert.deepEqual(read.pattern("acme/purr"), file, "without the results of pattern.get");
  assert.equal(read.pattern("mine/purr").name, "mine/purr");
  assert.deepEqual(new Keyframes().wave(), {});
});

test("each key frame of a file is kept within 1 ms of its time, or the file is refused", () => {
  const read = (...times) => Keyframes.read(JSON.stringify({ keyframes: times.map((t_ms, i) => ({ t_ms, level: i / 10 })) }));
  const kept = (...times) => read(...times).frames.map(({ t, level }) => [t, 10 * level]);
  assert.deepEqual(kept(0, 100, 100, 101), [[0, 0], [100, 1], [101, 2], [102, 3]]);
  assert.deepEqual(kept(0, 100.2, 100.4), [[0, 0], [100, 1], [101, 2]]);
  assert.deepEqual([read(0, 100, 100, 101).moved, read(0, 100).moved], [2, 0]);
  const refused = (...times) => errorOf({ keyframes: times.map((t_ms) => ({ t_ms, level: 0 })) });
  assert.equal(refused(0, 100, 100, 100), "this page keeps one key frame a millisecond, and the file has more at 100 ms");
  assert.equal(refused(0, 10_000, 10_000), "two of its key frames are at 10000 ms, the end of this page");
});

test("a file that is no pattern is refused with the reason", () => {
  assert.equal(errorOf("{"), "this file is no JSON");
  assert.equal(errorOf({}), "this file has no keyframes");
  assert.equal(errorOf({ keyframes: [{ t_ms: 5, level: 0 }, { t_ms: 1, level: 0 }] }), "its times are not in order");
  assert.equal(errorOf({ keyframes: [{ t_ms: 0, level: 2 }] }), "one of its levels is not 0 to 1");
  assert.equal(errorOf({ keyframes: [{ t_ms: 11_000, level: 1 }] }), "it is longer than the 10 s of this page");
  assert.equal(errorOf({ keyframes: [{ t_ms: 0, level: 1, direction: "there" }] }), "one of its directions is none");
  assert.equal(errorOf({ keyframes: [{ t_ms: 0, level: 1, ease: "cubic" }] }), "one of its ways is not linear, step or smooth");
  assert.equal(errorOf({ keyframes: [{ t_ms: 0, level: 1, gain: 1 }] }), "this page does not know gain of a key frame");
});

test("a drag becomes few key frames that are off by at most the tolerance", () => {
  const points = Array.from({ length: 300 }, (_, i) => ({
    t: 10 * i, direction: vector(i < 150 ? i : 150, 30 * Math.sin(i / 40)) }));
  const drawn = Keyframes.drawn(points, 0.7, 3);
  assert.ok(drawn.frames.length < 25, `${drawn.frames.length}`);
  assert.equal(drawn.length(), 2990);
  for (const { t, direction } of points) assert.ok(off(drawn.at(t).direction, direction) <= 3.01, `${t}`);
});
