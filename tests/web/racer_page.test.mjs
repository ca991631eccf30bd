// SPDX-License-Identifier: MIT
// The page of the racing game at common screen sizes: clock, laps, effects, sound, and no overlaps.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop, kPhone } from "./browser.mjs";
import { kTimeout } from "./timeouts.mjs";
import { pageErrors, kSmall, open, page, racer, startRacer, until } from "./race.mjs";

test("a time is rounded before it is divided into minutes", async () => {
  await startRacer();
  await open();
  const shown = await page.evaluate(() => [0, 59.94, 59.96, 61.25, 179.96, null].map(window.racer.clock));
  assert.deepEqual(shown, ["0:00.0", "0:59.9", "1:00.0", "1:01.3", "3:00.0", "–"]);
});

test("the clock stands until the first movement", async () => {
  await startRacer();
  await open();
  await until(() => window.racer.scene().time_s > 1);
  assert.equal(await page.textContent("#time"), "0:00.0");
  await page.keyboard.down("ArrowUp");
  await until(() => window.racer.scene().throttle === 1 && document.getElementById("time").textContent !== "0:00.0");
  const { time_s: time, lap_s: lap } = await page.evaluate(() => window.racer.scene());
  assert.ok(lap < time - 0.9, `${lap} s of ${time} s`);
});

test("a lap of the built-in driver is no best lap", async () => {
  await startRacer({ more: ["--driver"] });
  await open();
  await until(() => window.racer.scene().last_s !== null);
  assert.equal(await page.evaluate(() => window.racer.scene().best_s), null);
  assert.equal(await page.textContent("#best"), "–");
  assert.match(await page.textContent("#lapdone"), /^Lap 1: \d:\d\d\.\d, by the driver$/);
});

/** Pairs of panels that overlap, and panels that overflow the screen. */
const overlapping = () => page.evaluate(() => {
  const names = [".race", ".chart", ".ball", ".panel", "#keys", "#gone", "[data-hold=left]", "[data-hold=right]", "[data-hold=brake]", "[data-hold=throttle]", "#lapdone"];
  const shown = names.map((name) => [name, document.querySelector(name)])
    .filter(([, element]) => getComputedStyle(element).visibility !== "hidden" && element.getBoundingClientRect().width > 0 && element.textContent + element.children.length !== "0")
    .map(([name, element]) => [name, element.getBoundingClientRect()]);
  const found = [];
  shown.forEach(([name, a], i) => {
    if (a.left < -0.5 || a.top < -0.5 || a.right > innerWidth + 0.5 || a.bottom > innerHeight + 0.5) found.push(`${name} sticks out`);
    for (const [other, b] of shown.slice(i + 1)) {
      if (a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5) found.push(`${name} and ${other}`);
    }
  });
  for (const button of document.querySelectorAll(".panel button, .panel label")) {
    const [inner, outer] = [button, button.closest(".panel")].map((element) => element.getBoundingClientRect());
    if (inner.right > outer.right || inner.left < outer.left || button.scrollWidth > button.clientWidth + 1) found.push(`${button.textContent.trim()} in the panel`);
  }
  return found;
});
const touch = (width, height) => ({ ...kPhone, viewport: { width, height } });
const kSizes = [
  { viewport: { width: 800, height: 500 } }, { viewport: { width: 1000, height: 600 } }, kDesktop,
  touch(390, 844), touch(360, 640), touch(844, 390),
];

test("no panel lies over another, at any size", async () => {
  await startRacer();
  for (const device of kSizes) {
    await page?.context().close();
    await open(device);
    await page.evaluate(() => window.racer.link.dispatchEvent(
      new CustomEvent("lap", { detail: { lap: 12, time_s: 75.3, best: true, driver: false } })));
    assert.deepEqual(await overlapping(), [], JSON.stringify(device.viewport));
  }
});

test("a banner covers neither speed nor map", async () => {
  await startRacer();
  await open(touch(390, 844));
  pageErrors.expected = true;
  await racer.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  assert.deepEqual(await overlapping(), []);
});

test("an impact is drawn at the car, where it was felt", async () => {
  await startRacer();
  await open();
  await page.keyboard.down("ArrowUp");
  await page.keyboard.down("ArrowLeft");
  const { drawn, felt } = await (await until(() => {
    const { ring, stage } = window.racer;
    const mark = stage().impact?.mark;
    return ring.last?.kind === "hit" && mark?.visible && { drawn: mark.position.toArray(), felt: ring.last.direction };
  })).jsonValue();
  const apart = Math.hypot(...drawn);
  assert.ok(apart > 0.5 && apart < 4, `${apart} m from the middle of the car`);
  // The centre of its box is slightly above the car's origin.
  assert.ok(Math.abs(Math.atan2(drawn[1], drawn[0]) - Math.atan2(felt[1], felt[0])) < 0.05, JSON.stringify({ drawn, felt }));
  await page.keyboard.up("ArrowUp");
  await page.keyboard.up("ArrowLeft");
  await until(() => !window.racer.stage().impact.mark.visible);
});

test("there is no sound until it is enabled", async () => {
  await startRacer({ more: ["--driver"] });
  await open(kSmall);
  assert.equal(await page.evaluate(() => window.racer.sound.context), null);
  const button = page.getByRole("button", { name: "Sound" });
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  await button.click();
  assert.equal(await button.getAttribute("aria-pressed"), "true");
  await until(() => window.racer.sound.context.state === "running");
  // Sound is audible.
  await page.evaluate(() => {
    const { sound } = window.racer;
    window.analyser = sound.context.createAnalyser();
    sound.master.connect(window.analyser);
  });
  await until(() => {
    const samples = new Float32Array(window.analyser.fftSize);
    window.analyser.getFloatTimeDomainData(samples);
    return Math.max(...samples.map(Math.abs)) > 0.005;
  });
  await button.click();
  await until(() => window.racer.sound.context.state === "suspended");
  assert.equal(await button.getAttribute("aria-pressed"), "false");
});
