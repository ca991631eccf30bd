// SPDX-License-Identifier: MIT
// Sound input of the designer: the sound of a file and of a microphone becomes effects of a real daemon while it plays.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop } from "./browser.mjs";
import { daemon, messagesOf, open, page, until } from "./dashboard.mjs";
import { eventually } from "./timeouts.mjs";

/** 16 bit, two channels, 48 kHz. */
function wav(seconds, sound) {
  const [rate, count] = [48_000, Math.round(48_000 * seconds)];
  const bytes = Buffer.alloc(44 + 4 * count);
  bytes.write("RIFF");
  bytes.writeUInt32LE(36 + 4 * count, 4);
  bytes.write("WAVEfmt ", 8);
  for (const [at16, value] of [[20, 1], [22, 2], [32, 4], [34, 16]]) bytes.writeUInt16LE(value, at16);
  for (const [at32, value] of [[16, 16], [24, rate], [28, 4 * rate], [40, 4 * count]]) bytes.writeUInt32LE(value, at32);
  bytes.write("data", 36);
  for (let i = 0; i < count; ++i) sound(i / rate).forEach((v, side) => bytes.writeInt16LE(Math.round(32_767 * v), 44 + 4 * i + 2 * side));
  return bytes;
}

test("a sound file vibrates where its low tone is and pushes where its high tones begin", async () => {
  let sent;
  await open("/designer.html", kDesktop, (opened) => { sent = messagesOf(opened); });
  assert.equal((await daemon.call("device.status")).effects.length, 0, "off until it is started");
  // The low tone grows, so that it has no onset. Both it and the pauses are longer than the windows of a busy machine.
  const low = (t) => 0.5 * Math.min(1, t) * Math.sin(2 * Math.PI * 60 * t);
  const high = (t) => (t % 4 > 1 && t % 4 < 2.5 ? 0.5 * Math.sin(2 * Math.PI * 2000 * t) : 0);
  // Longer than a busy machine needs for the following steps: a sound that has ended cannot be stopped.
  const buffer = wav(20, (t) => [low(t), high(t)]);
  await page.locator("#sound").setInputFiles({ name: "s.wav", mimeType: "audio/wav", buffer });
  await eventually(async () => (await daemon.call("device.status")).effects.some(({ slot }) => slot === "sound"));
  await until(() => (window.dashboard.ball.extension(34) ?? 0) > 0.01);
  await until(() => /^\d+ push/.test(document.getElementById("heard").textContent));
  await eventually(async () => await daemon.ended("completed") > 0);
  const sides = (name) => sent.filter(({ method }) => method === name).map(({ params }) => params.direction.azimuth_deg);
  assert.ok(sides("effect.pulse").every((azimuth) => azimuth < -80), `begins on the right: ${sides("effect.pulse")}`);
  assert.ok(sides("effect.vibrate").some((azimuth) => azimuth > 45), `the tone is on the left: ${sides("effect.vibrate")}`);
  await page.getByRole("button", { name: "End the sound" }).click();
  await eventually(async () => (await daemon.call("device.status")).effects.length === 0);
});

test("a microphone that beeps pushes at each beep, until the sound is ended", async () => {
  await open("/designer.html");
  const microphone = page.getByRole("button", { name: "Listen to the microphone" });
  assert.equal(await microphone.getAttribute("aria-pressed"), "false");
  assert.equal(await page.evaluate(() => window.dashboard.listener.context), null, "off until it is started");
  await microphone.click();
  await until(() => document.getElementById("microphone").getAttribute("aria-pressed") === "true");
  await until(() => /^([2-9]|\d{2,}) pushes$/.test(document.getElementById("heard").textContent));
  await eventually(async () => await daemon.ended("completed") > 1);
  const tracks = await page.evaluateHandle(() => window.dashboard.listener.stream.getTracks());
  await page.getByRole("button", { name: "End the sound" }).click();
  await until(() => document.getElementById("microphone").getAttribute("aria-pressed") === "false");
  assert.deepEqual(await tracks.evaluate((all) => all.map(({ readyState }) => readyState)), ["ended"], "the microphone is off");
  assert.equal(await page.locator("#silence").isDisabled(), true);
  await eventually(async () => (await daemon.call("device.status")).effects.length === 0);
});

test("a refused microphone is reported, and nothing is recorded", async () => {
  await open("/designer.html", kDesktop, (refused) => refused.addInitScript(() => {
    navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException("Permission denied", "NotAllowedError"));
  }));
  await page.getByRole("button", { name: "Listen to the microphone" }).click();
  await until(() => document.getElementById("heard").textContent === "No sound: Permission denied");
  assert.equal(await page.locator("#silence").isDisabled(), true);
  assert.equal(await page.getByRole("button", { name: "Listen to the microphone" }).getAttribute("aria-pressed"), "false");
});
