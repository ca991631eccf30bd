// SPDX-License-Identifier: MIT
// Recording by demonstration on the designer's ball, against a real daemon: the ball plays a drag during the movement,
// and the drag becomes key frames, regardless of how it ends.
import assert from "node:assert/strict";
import { test } from "node:test";

import { pageErrors, daemon, open, page, until } from "./dashboard.mjs";
import { eventually } from "./timeouts.mjs";

const frames = () => page.evaluate(() => window.dashboard.frames());
const awaitMessage = (text) => until((expected) => document.getElementById("said").textContent.startsWith(expected), text);
const felt = async () => (await daemon.call("device.status")).effects.some(({ slot }) => slot === "drag");
const rests = async () => (await daemon.call("device.status")).effects.length === 0;
/** Moves the pointer to a position from the left (0) to the right (1) of the ball. */
async function to(share) {
  const box = await page.locator("#ball").boundingBox();
  await page.mouse.move(box.x + (0.45 + 0.1 * share) * box.width, box.y + 0.5 * box.height);
}
async function begin() {
  await page.getByRole("button", { name: "Record a drag" }).click();
  await to(0);
  await page.mouse.down();
  await eventually(felt);
}
const recording = () => page.locator("#record").getAttribute("aria-pressed");

test("a drag on the ball is felt meanwhile and becomes key frames", async () => {
  await open("/designer.html");
  await begin();
  for (let i = 1; i <= 20; ++i) await to(i / 20);
  await page.mouse.up();
  await until(() => window.dashboard.frames().length >= 2);
  const drawn = await frames();
  assert.ok(drawn[0].direction[1] > drawn.at(-1).direction[1] + 0.2, "from the left to the right");
  await eventually(rests);
});

test("a press without a movement records nothing and changes nothing", async () => {
  await open("/designer.html");
  await page.getByRole("button", { name: "Add key frame" }).click();
  const before = await frames();
  await begin();
  await page.mouse.up();
  await awaitMessage("Nothing was recorded: the pointer did not move on the ball.");
  assert.deepEqual(await frames(), before);
  assert.equal(await recording(), "false");
  await eventually(rests);
});

test("a drag that leaves the ball continues where it returns", async () => {
  await open("/designer.html");
  await begin();
  await to(0.3);
  const box = await page.locator("#ball").boundingBox();
  await page.mouse.move(box.x + 10, box.y + 10);
  await to(1);
  await page.mouse.up();
  const drawn = await frames();
  assert.ok(drawn.length >= 2);
  assert.ok(drawn.every(({ direction }) => direction[0] < 0), "no point of it is beside the side that is seen");
});

test("a drag that is too long ends by itself after ten seconds", async () => {
  await open("/designer.html", undefined, (drawn) => drawn.addInitScript(() => {
    window.aheadMs = 0;
    const now = performance.now.bind(performance);
    performance.now = () => now() + window.aheadMs;
  }));
  await begin();
  for (let i = 1; i <= 5; ++i) await to(i / 10);
  await page.evaluate(() => { window.aheadMs = 10_001; });
  await until(() => document.getElementById("record").getAttribute("aria-pressed") === "false");
  const drawn = await frames();
  assert.ok(drawn.length >= 2 && drawn.at(-1).t <= 10_000);
  await eventually(rests);
  await to(1);
  await page.mouse.up();
  assert.deepEqual(await frames(), drawn, "what follows is no part of it");
});

test("the end of a daemon during a drag keeps the drawn part", async () => {
  await open("/designer.html");
  await begin();
  for (let i = 1; i <= 10; ++i) await to(i / 20);
  pageErrors.expected = true;
  await daemon.end("SIGKILL");
  await until(() => document.body.dataset.link !== "open");
  for (let i = 11; i <= 20; ++i) await to(i / 20);
  await page.mouse.up();
  await until(() => window.dashboard.frames().length >= 2);
  const drawn = await frames();
  assert.ok(drawn[0].direction[1] > drawn.at(-1).direction[1] + 0.2, "from the left to the right, to its end");
});
