// SPDX-License-Identifier: MIT
// The designer's forecast as sound: what a real daemon's preview sounds like, rendered by the browser without a loudspeaker.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop } from "./browser.mjs";
import { messagesOf, open, page, until } from "./dashboard.mjs";
import { eventually } from "./timeouts.mjs";

const kRate = 48_000;
const hear = () => page.getByRole("button", { name: "Hear" });
const load = (pattern) => page.locator("#load").setInputFiles({
  name: "p.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(pattern)) });
const push = (t_ms, direction, level, ease = "linear") => ({ t_ms, direction, level, ease });

/** The designer, whose sound is rendered for 1.5 s instead of played. */
const openSilently = () => open("/designer.html", kDesktop, (silent) => silent.addInitScript((rate) => {
  window.AudioContext = class extends OfflineAudioContext {
    constructor() {
      super(2, 1.5 * rate, rate);
    }
    async close() {}
  };
}, kRate));

/** The samples of both sides of the forecast of `pattern`. */
async function rendered(pattern) {
  await openSilently();
  await load(pattern);
  await until(() => document.getElementById("currents").points.length > 10);
  await hear().click();
  await until(() => window.dashboard.audition.sounding !== null);
  return page.evaluate(async () => {
    const sound = await window.dashboard.audition.context.startRendering();
    return [0, 1].map((side) => [...sound.getChannelData(side)]);
  });
}
const between = (samples, fromS, toS) => samples.slice(fromS * kRate, toS * kRate);
const rms = (samples) => Math.sqrt(samples.reduce((sum, v) => sum + v * v, 0) / samples.length);

const loudest = (samples) => samples.reduce((most, v) => Math.max(most, Math.abs(v)), 0);

test("the forecast is as loud as its current, on the side of the push, and ends with the effect", async () => {
  const [left, right] = await rendered(
    { name: "a/b", keyframes: [push(0, "left", 1, "step"), push(500, "right", 0.5), push(1000, "right", 0.5)] });
  const [strong, weak] = [rms(between(left, 0.1, 0.4)), rms(between(right, 0.6, 0.9))];
  assert.ok(strong > 0.1 && strong < 0.3, `${strong}`);
  assert.ok(Math.abs(weak / strong - 0.5) < 0.03, `${weak} of ${strong}`);
  assert.ok(rms(between(right, 0.1, 0.4)) < 0.01 * strong);
  assert.ok(rms(between(left, 0.6, 0.9)) < 0.01 * strong);
  assert.equal(Math.max(loudest(between(left, 1.01, 1.5)), loudest(between(right, 1.01, 1.5))), 0);
});

const steady = (wave, ms) => ({ name: "a/b", ...wave, keyframes: [push(0, "front", 1), push(ms, "front", 1)] });

test("a wave that is a tone is heard with its frequency, a slower one as it rises and falls", async () => {
  const rises = (samples) => samples.filter((v, i) => i > 0 && samples[i - 1] < 0 && v >= 0).length;
  for (const [wave, hz] of [[{ waveform: "sine" }, 60], [{ waveform: "sine", frequency_hz: 40 }, 40], [{ waveform: "square", frequency_hz: 2 }, 110]]) {
    const [left, right] = await rendered(steady(wave, 1000));
    const loud = between(left, 0.05, 0.2);
    assert.ok(Math.abs(rises(loud) - 0.15 * hz) <= 1, `${rises(loud)} periods`);
    assert.ok(Math.abs(rms(loud) / rms(between(right, 0.05, 0.2)) - 1) < 0.01, "in the middle");
    assert.equal(rms(between(left, 0.3, 0.45)) > 0.01, wave.waveform === "sine");
    await page.context().close();
  }
});

test("a tone keeps its loudness where the forecast's steps do not fit its period", async () => {
  const [left] = await rendered(steady({ waveform: "sine", frequency_hz: 40 }, 3400));
  const period = (i) => between(left, 0.2 + i / 40, 0.2 + (i + 1) / 40);
  const parts = Array.from({ length: 40 }, (_, i) => rms(period(i)));
  assert.ok(Math.max(...parts) < 1.2 * Math.min(...parts), `${parts}`);
});

test("nothing sounds unasked; once asked, each edit does, until it is turned off", async () => {
  let sent;
  await open("/designer.html", kDesktop, (opened) => { sent = messagesOf(opened); });
  const shown = async (count) => {
    await eventually(() => sent.filter(({ method }) => method === "effect.preview").length === count);
    await until(() => document.getElementById("currents").points.length > 10);
  };
  await load(steady({}, 1000));
  await shown(1);
  assert.equal(await page.evaluate(() => window.dashboard.audition.sounding), null);
  await hear().click();
  await until(() => window.dashboard.audition.sounding !== null);
  await until(() => window.dashboard.audition.context.state === "running");
  const sounding = () => page.evaluateHandle(() => window.dashboard.audition.sounding);
  const first = await sounding();
  await page.locator("[name=time]").fill("500");
  await shown(3);
  assert.equal(await page.evaluate((before) => window.dashboard.audition.sounding === before, first), true, "the same effect");
  await page.locator("[name=strength]").fill("4");
  await until((before) => ![null, before].includes(window.dashboard.audition.sounding), first);
  await hear().click();
  await until(() => window.dashboard.audition.context === null);
  assert.equal(await hear().getAttribute("aria-pressed"), "false");
  assert.equal(await page.evaluate(() => window.dashboard.audition.sounding), null);
});
