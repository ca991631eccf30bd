// SPDX-License-Identifier: MIT
// The dashboard's display of heat: the hottest winding first, beside the thresholds that are compared with it; unknown
// values are marked as unknown.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop } from "./browser.mjs";
import { open, page, until } from "./dashboard.mjs";
import { kTimeout } from "./timeouts.mjs";

/** Lets `change` rewrite each status that the daemon sends. */
const rewriting = (change) => (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
  const server = socket.connectToServer();
  server.onMessage((text) => {
    const message = JSON.parse(text);
    if (message.method === "telemetry") change(message.params);
    socket.send(JSON.stringify(message));
  });
});
const derated = (status) => {
  status.derating = true;
  status.temperature_c = { sensor: 38.3, model: 66, coils: [38.4, 66, 40.1], sensors: [38.3, 65.2, 40], upper: 67.2, core: 37, skin: 33, age_ms: 20 };
};
const text = (selector) => page.locator(selector).innerText();

test("the hottest winding leads, beside its own thresholds; the thermistor is second and named", async () => {
  await open("/", kDesktop, rewriting(derated));
  await until(() => document.getElementById("hottest")?.textContent === "66.0 °C");
  const heat = await text(".heat");
  assert.match(heat, /^Hottest winding\s+66\.0 °C\s+at most 67\.2 °C\s+Derated from 60\.0 °C, trips at 70\.0 °C\.\s+Thermistor on winding [xyz]\s+38\.3 °C/);
  assert.match(await text("#charts figure >> nth=0"), /^Hottest winding\s+66\.0 °C/);
});

test("the temperature of each winding is one click away", async () => {
  await open("/", kDesktop, rewriting(derated));
  await until(() => document.getElementById("hottest")?.textContent === "66.0 °C");
  assert.ok(!await page.locator("#windings table").isVisible());
  await page.locator("#windings summary").click();
  assert.match(await text("#windings table"), /x\s+38\.4 °C\s+38\.3 °C\s+y\s+66\.0 °C\s+65\.2 °C\s+z\s+40\.1 °C\s+40\.0 °C/);
});

test("a ball that is derated has no green dot", async () => {
  const dot = () => page.evaluate(() => getComputedStyle(document.getElementById("state"), "::before").backgroundColor);
  await open();
  await until(() => document.getElementById("state").textContent === "Armed");
  const green = await dot();
  await page.context().close();
  await open("/", kDesktop, rewriting(derated));
  await until(() => document.getElementById("state").textContent === "Armed, derated");
  assert.notEqual(await dot(), green);
});

test("without a thermometer the remaining time is shown as unknown", async () => {
  await open();
  await until(() => document.getElementById("headroom").textContent === "for ever");
  await page.selectOption("[name=fault]", "sensor_open");
  await page.waitForSelector("body[data-state=tripped]", kTimeout);
  await until(() => document.getElementById("headroom").textContent === "not known");
  assert.equal(await text("#burst"), "not known");
  assert.equal(await text("#thermistor"), "no reading");
});

test("a status without an estimate is no temperature", async () => {
  await open("/", kDesktop, rewriting((status) => {
    status.temperature_c = { sensor: null, model: null, coils: [25, 25, 25], age_ms: null };
    delete status.headroom_s;
    delete status.burst_s;
  }));
  await until(() => document.getElementById("hottest")?.textContent === "not known");
  assert.equal(await text("#headroom"), "not known");
  assert.equal(await text("#burst"), "not known");
  assert.equal(await text("#bound"), "");
  await page.locator("#windings summary").click();
  assert.doesNotMatch(await text("#windings"), /25/);
});
