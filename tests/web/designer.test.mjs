// SPDX-License-Identifier: MIT
// The designer in a browser, against a real daemon: key frames on the ball are placed, selected, moved, forecast,
// played, saved and loaded.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { kDesktop, kPhone } from "./browser.mjs";
import { daemon, messagesOf, open, page, until } from "./dashboard.mjs";
import { eventually } from "./timeouts.mjs";

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
  await eventually(async () => await daemon.ended("completed") > 0);
});

const chosen = () => page.locator("#frames tr[aria-current]").evaluateAll((rows) => rows.map((row) => row.rowIndex));
/** The screen position of a key frame. */
const markAt = (index) => page.evaluate((which) => window.dashboard.path.screen(which), index);

/** Three key frames, from the left to the right of the visible side. */
async function threeFrames() {
  await open("/designer.html");
  for (const [t, x] of [[0, 0.45], [700, 0.5], [1500, 0.55]]) {
    await at(t);
    await clickBall(x, 0.5);
  }
  assert.equal((await frames()).length, 3);
}

test("key frames are marks on the ball where they were put, with the path between them as dots", async () => {
  await open("/designer.html");
  await clickBall(0.47, 0.45);
  const box = await page.locator("#ball").boundingBox();
  const [x, y] = await markAt(0);
  assert.ok(Math.hypot(x - box.x - 0.47 * box.width, y - box.y - 0.45 * box.height) < 2, "under the pointer");
  const drawn = () => page.evaluate(() => [window.dashboard.path.marks.count, window.dashboard.path.dots.count]);
  assert.deepEqual(await drawn(), [1, 0]);
  await at(500);
  await clickBall(0.55, 0.5);
  assert.deepEqual(await drawn(), [2, 49], "a dot every 10 ms");
  await page.getByRole("button", { name: "Clear" }).click();
  assert.deepEqual(await drawn(), [0, 0]);
});

test("a press on a key frame of the ball chooses it, and a drag moves it there and in the table", async () => {
  await threeFrames();
  const before = await frames();
  const [x, y] = await markAt(1);
  await page.mouse.click(x, y);
  assert.deepEqual(await frames(), before, "no other one was put");
  assert.deepEqual(await chosen(), [2]);
  assert.match(await page.textContent("#caption"), /^Key frame 2 of 3, at 0\.70 s towards /);
  assert.equal(await page.locator("[name=time]").inputValue(), "700");

  const view = () => page.evaluate(() => window.dashboard.ball.camera.position.toArray());
  const seenFrom = await view();
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(x + i, y - 4 * i);
  await page.mouse.up();
  const after = await frames();
  assert.deepEqual(after.map(({ t }) => t), [0, 700, 1500]);
  assert.deepEqual([after[0], after[2]], [before[0], before[2]]);
  assert.ok(after[1].direction[2] > before[1].direction[2] + 0.2, "up");
  const [movedX, movedY] = await markAt(1);
  assert.ok(Math.hypot(movedX - x - 10, movedY - y + 40) < 2, "it follows the pointer");
  assert.deepEqual(await view(), seenFrom, "and the view stays");
  const shown = Number(await page.getByLabel("elevation of key frame 2").inputValue());
  assert.ok(Math.abs(shown - (Math.asin(after[1].direction[2]) * 180) / Math.PI) < 1);
  await until(() => document.getElementById("currents").points.length > 10);
});

test("the chosen key frame has its level from the slider and goes with Delete", async () => {
  await threeFrames();
  await page.mouse.click(...await markAt(1));
  await page.locator("[name=level]").fill("0.4");
  assert.deepEqual((await frames()).map(({ level }) => level), [1, 0.4, 1]);
  await page.keyboard.press("Delete");
  assert.deepEqual((await frames()).map(({ t }) => t), [0, 1500]);
  assert.deepEqual(await chosen(), []);
  await page.keyboard.press("Delete");
  assert.equal((await frames()).length, 2, "none is chosen");
  await page.mouse.click(...await markAt(1));
  await page.locator("[name=name]").focus();
  await page.keyboard.press("Delete");
  assert.equal((await frames()).length, 2, "of the name's letters");
});

test("a key frame behind the ball is not taken through it, and a drag beside all turns the view", async () => {
  await threeFrames();
  await page.getByLabel("azimuth of key frame 2").fill("0");
  await page.getByLabel("azimuth of key frame 2").press("Enter");
  await page.getByLabel("elevation of key frame 2").fill("0");
  await page.getByLabel("elevation of key frame 2").press("Enter");
  assert.equal(await page.evaluate(() => window.dashboard.path.hidden(1)), true, "the holder looks at the back");
  assert.equal(await page.evaluate(() => window.dashboard.path.hidden(0)), false);
  await at(1000);
  await page.mouse.click(...await markAt(1));
  assert.equal((await frames()).length, 4, "a new one before it");
  const seenFrom = await page.evaluate(() => window.dashboard.ball.camera.position.y);
  await page.locator("#ball").scrollIntoViewIfNeeded();
  const box = await page.locator("#ball").boundingBox();
  const low = box.y + 0.9 * box.height;
  await page.mouse.move(box.x + 20, low);
  await page.mouse.down();
  await page.mouse.move(box.x + 120, low, { steps: 5 });
  await page.mouse.up();
  const turned = await page.evaluate(() => window.dashboard.ball.camera.position.y);
  assert.ok(Math.abs(turned - seenFrom) > 10, `${turned}`);
  assert.equal((await frames()).length, 4);
});

test("a pattern saved in the daemon is listed there, and a refusal has its reason", async () => {
  await threeFrames();
  await page.locator("[name=name]").fill("acme/wave");
  await page.getByRole("button", { name: "Keep in the daemon" }).click();
  await until(() => document.getElementById("said").textContent === "acme/wave is stored in the daemon");
  const { keyframes, duration_ms } = await daemon.call("pattern.get", { name: "acme/wave" });
  assert.equal(duration_ms, 1500);
  assert.deepEqual(keyframes.map(({ t_ms }) => t_ms), [0, 700, 1500]);
  assert.equal((await daemon.call("effect.play", { pattern: "acme/wave", on_close: "finish" })).current_a > 0, true);
  await page.locator("[name=name]").fill("No Name");
  await page.getByRole("button", { name: "Keep in the daemon" }).click();
  await until(() => /is not a valid pattern name/.test(document.getElementById("said").textContent));
  assert.equal(await page.locator("#said.bad").count(), 1);
  await page.getByRole("button", { name: "Clear" }).click();
  await page.getByRole("button", { name: "Keep in the daemon" }).click();
  await until(() => document.getElementById("said").textContent === "There is nothing to keep yet.");
});

test("a saved file is accepted by the daemon and loaded by this page", async () => {
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

test("a file's wave is forecast, played, kept and saved, with the members that this page does not know", async () => {
  let sent;
  await open("/designer.html", kDesktop, (opened) => { sent = messagesOf(opened); });
  const file = { name: "acme/blink", description: "On and off.", waveform: "square", frequency_hz: 2, on_fraction: 0.5,
    keyframes: [{ t_ms: 0, direction: [1, 0, 0], level: 1 }, { t_ms: 1000, direction: [1, 0, 0], level: 1 }] };
  const load = (pattern) => page.locator("#load").setInputFiles({
    name: "p.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(pattern)) });
  await load(file);
  // Off from 250 to 500 ms; the timeline shows 2 s as 1000 units, and rest at the height 160.
  await until(() => [...document.getElementById("currents").points].some(({ x, y }) => x > 150 && x < 240 && y === 160));
  assert.equal(await page.textContent("#wave"), "Modulated as in the file: square, 2 Hz, on for 50 %");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await until(() => /^plays with /.test(document.getElementById("said").textContent));
  const { waveform, frequency_hz, on_fraction } = sent.find(({ method }) => method === "effect.play").params;
  assert.deepEqual([waveform, frequency_hz, on_fraction], ["square", 2, 0.5]);
  await page.getByRole("button", { name: "Keep in the daemon" }).click();
  await until(() => document.getElementById("said").textContent === "acme/blink is stored in the daemon");
  const { duration_ms, shipped, ...kept } = await daemon.call("pattern.get", { name: "acme/blink" });
  assert.deepEqual([duration_ms, shipped], [1000, false]);
  assert.deepEqual(kept, file);

  await load({ ...file, licence: "MIT", keyframes: [file.keyframes[0], file.keyframes[0], file.keyframes[1]] });
  await until(() => document.getElementById("said").textContent === "1 key frame moved by 1 ms: others are at its time");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save" }).click();
  const saved = JSON.parse(readFileSync(await (await download).path(), "utf8"));
  assert.deepEqual(saved, { ...file, licence: "MIT",
    keyframes: [file.keyframes[0], { ...file.keyframes[0], t_ms: 1 }, file.keyframes[1]] });
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await page.locator("#wave").isHidden(), true);
});

test("the designer fits a phone", async () => {
  await open("/designer.html", kPhone);
  await page.getByRole("button", { name: "Add key frame" }).click();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
});
