// SPDX-License-Identifier: MIT
// The designer in a browser, against a real daemon: key frames put on the ball are forecast, played, saved and loaded, a
// drag becomes a pattern, and sound becomes effects.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { kPhone } from "./browser.mjs";
import { daemon, open, page, until } from "./dashboard.mjs";
import { comes } from "./patience.mjs";

const frames = () => page.evaluate(() => window.dashboard.frames());
const at = (ms) => page.locator("[name=time]").fill(String(ms));
const clickBall = async (x, y) => {
  const box = await page.locator("#ball").boundingBox();
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
};

test("clicks on the ball become key frames, which are forecast and played", async () => {
  await open("/designer.html");
  await clickBall(0.5, 0.5);
  await at(800);
  await clickBall(0.42, 0.5);
  const put = await frames();
  assert.deepEqual(put.map(({ t }) => t), [0, 800]);
  assert.ok(put[0].direction[0] < -0.5, "the holder looks at the back");
  await until(() => document.getElementById("currents").points.length > 10);
  assert.match(await page.textContent("#forecast"), /^at most 5\.0 A, /);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await until(() => /^plays with 5\.0 A/.test(document.getElementById("said").textContent));
  await comes(async () => await daemon.ended("completed") > 0);
});

test("what is saved is a pattern that the daemon takes and this page loads", async () => {
  await open("/designer.html");
  await page.getByRole("button", { name: "Add key frame" }).click();
  await at(1500);
  await page.getByRole("button", { name: "Add key frame" }).click();
  await page.getByLabel("azimuth of key frame 2").fill("90");
  await page.getByLabel("azimuth of key frame 2").press("Enter");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save" }).click();
  const text = readFileSync(await (await download).path(), "utf8");
  const saved = JSON.parse(text);
  assert.deepEqual(saved.keyframes.map(({ t_ms, direction }) => [t_ms, ...direction]), [[0, 1, 0, 0], [1500, 0, 1, 0]]);
  assert.equal((await daemon.call("pattern.put", saved)).duration_ms, 1500);
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal((await frames()).length, 0);
  await page.locator("#load").setInputFiles({ name: "p.json", mimeType: "application/json", buffer: Buffer.from(text) });
  await until(() => window.dashboard.frames().length === 2);
  await page.locator("#load").setInputFiles({ name: "p.json", mimeType: "application/json", buffer: Buffer.from("{}") });
  await until(() => document.getElementById("said").textContent === "This file has no keyframes");
  assert.equal((await frames()).length, 2);
});

test("a drag on the ball is felt meanwhile and becomes key frames", async () => {
  await open("/designer.html");
  await page.getByRole("button", { name: "Record a drag" }).click();
  const box = await page.locator("#ball").boundingBox();
  const to = (share) => page.mouse.move(box.x + (0.45 + 0.1 * share) * box.width, box.y + 0.5 * box.height);
  await to(0);
  await page.mouse.down();
  await comes(async () => (await daemon.call("device.status")).effects.some(({ slot }) => slot === "drag"));
  for (let i = 1; i <= 20; ++i) await to(i / 20);
  await page.mouse.up();
  await until(() => window.dashboard.frames().length >= 2);
  const drawn = await frames();
  assert.ok(drawn[0].direction[1] > drawn.at(-1).direction[1] + 0.2, "from the left to the right");
  await comes(async () => (await daemon.call("device.status")).effects.length === 0);
});

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

test("a sound file vibrates where its low tone is and pushes where it clicks", async () => {
  await open("/designer.html");
  assert.equal((await daemon.call("device.status")).effects.length, 0, "off until it is started");
  const click = (t) => (t % 0.5 < 0.005 ? Math.exp((-t % 0.5) / 0.001) * Math.cos(2 * Math.PI * 2000 * (t % 0.5)) : 0);
  // Longer than a busy machine takes for what follows: a sound that is over has nothing to be ended.
  const buffer = wav(20, (t) => [0.5 * Math.sin(2 * Math.PI * 60 * t), click(t)]);
  await page.locator("#sound").setInputFiles({ name: "s.wav", mimeType: "audio/wav", buffer });
  await comes(async () => (await daemon.call("device.status")).effects.some(({ slot }) => slot === "sound"));
  await until(() => (window.dashboard.ball.extension(34) ?? 0) > 0.01);
  await until(() => /^\d+ push/.test(document.getElementById("heard").textContent));
  await comes(async () => await daemon.ended("completed") > 0);
  await page.getByRole("button", { name: "End the sound" }).click();
  await comes(async () => (await daemon.call("device.status")).effects.length === 0);
});

test("the designer fits a phone", async () => {
  await open("/designer.html", kPhone);
  await page.getByRole("button", { name: "Add key frame" }).click();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
});
