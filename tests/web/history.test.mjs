// SPDX-License-Identifier: MIT
// Data from before the page was opened: the charts are filled from the daemon's history, over a reload and a restart.
// Also zoom, each winding, the gain, the recordings of trips.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { daemon, open, page, startDaemon, until } from "./dashboard.mjs";
import { eventually, kTimeout } from "./timeouts.mjs";

/** Plays 5 A for two seconds, waits until the daemon has stored them, and another second. */
const play = async () => {
  await daemon.call("effect.pulse", { direction: "left", current_a: 5, duration_ms: 2000, on_close: "finish" });
  await eventually(async () => (await daemon.call("telemetry.history", { seconds: 60 })).samples?.some(({ current_a: a, age_s: age }) => a > 3 && age > 0.5));
};
/** The maximum current in the chart before `opened`, device time in seconds; 0: none. */
const strongestBefore = async (opened) => {
  await until(() => window.dashboard?.charts?.()?.time.now > 0);
  return page.evaluate((end) => {
    const [times, flows] = window.dashboard.charts().current.data;
    return Math.max(0, ...flows.filter((_, i) => times[i] < end));
  }, opened);
};
const now = async () => (await daemon.call("ping")).time_ns * 1e-9;

test("a chart shows the currents before the page was opened", async () => {
  await play();
  for (const load of [open, () => page.reload()]) {
    const opened = await now();
    await load();
    assert.ok(await strongestBefore(opened) > 4);
  }
});

test("a chart shows the currents before a restart of the daemon", async () => {
  await play();
  const { home } = daemon;
  await daemon.end("SIGTERM", { keep: true });
  await startDaemon({ home });
  const opened = await now();
  await open();
  assert.ok(await strongestBefore(opened) > 4);
});

test("the charts show the chosen time, or the range that is dragged over", async () => {
  await open();
  await until(() => window.dashboard.charts?.()?.time.now > 0);
  const shown = () => page.evaluate(() => {
    const { plot } = window.dashboard.charts().headroom;
    return plot.scales.x.max - plot.scales.x.min;
  });
  assert.ok(Math.abs(await shown() - 120) < 1);
  await page.getByText("10 min", { exact: true }).click();
  assert.ok(Math.abs(await shown() - 600) < 1);
  await page.getByText("30 s", { exact: true }).click();
  assert.ok(Math.abs(await shown() - 30) < 1);
  const newest = page.getByRole("button", { name: "Newest" });
  assert.ok(!await newest.isVisible());
  await page.locator("[data-chart=temperature]").scrollIntoViewIfNeeded();
  const box = await page.locator("[data-chart=temperature] .u-over").boundingBox();
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 20, { steps: 4 });
  await page.mouse.up();
  // The whole history, no longer scrolling.
  assert.ok(Math.abs(await shown() - 9) < 1.5, `${await shown()} s`);
  await newest.click();
  assert.ok(Math.abs(await shown() - 30) < 1);
});

test("the lines of each winding are one click away", async () => {
  await open();
  await until(() => window.dashboard.charts?.()?.time.now > 0);
  const lines = () => page.evaluate(() => window.dashboard.charts().temperature.plot.series.filter(({ show }) => show).length - 1);
  assert.equal(await lines(), 4);
  await page.getByLabel("Each winding").check();
  assert.equal(await lines(), 7);
  assert.match(await page.locator("#charts figcaption").first().innerText(), /x\s+y\s+z/);
});

test("the gain is shown and set", async () => {
  await daemon.call("output.set_gain", { gain: 0.8 });
  await open();
  await until(() => document.querySelector("output[for=gain]").value === "80 %");
  await page.locator("#gain").fill("0.5");
  await eventually(async () => (await daemon.call("device.describe")).gain === 0.5);
  await until(() => /50 % of its strength/.test(document.getElementById("said").textContent));
});

test("the recording of a trip is saved by a click", async () => {
  await open();
  await page.selectOption("[name=fault]", "sensor_open");
  await page.waitForSelector("body[data-state=tripped]", kTimeout);
  const link = page.locator("#happened a");
  await link.first().waitFor(kTimeout);
  assert.equal(await link.count(), 1);
  const [download] = await Promise.all([page.waitForEvent("download"), link.click()]);
  assert.equal(download.suggestedFilename(), "trip-0001.hhr");
  const downloaded = readFileSync(await download.path());
  const recorded = readFileSync(join(daemon.home, "state/hedgehog/trip-0001.hhr"));
  assert.ok(downloaded.length > 1000 && downloaded.equals(recorded), `${downloaded.length} of ${recorded.length} bytes`);
});
