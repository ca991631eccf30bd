// SPDX-License-Identifier: MIT
// Screenshots of the pages: shots.mjs FOLDER.
import { mkdirSync } from "node:fs";

import { kDesktop, kPhone, launch } from "./browser.mjs";
import { Daemon } from "./daemon.mjs";
import { Racer } from "./racer.mjs";

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });
const daemon = await Daemon.start();
const racer = await Racer.start({ daemon, more: ["--driver"] });
const browser = await launch();
for (const [name, device] of [["desktop", kDesktop], ["phone", kPhone]]) {
  const page = await (await browser.newContext(device)).newPage();
  page.on("console", (message) => console.log(name, message.text()));
  page.on("pageerror", (error) => console.log(name, error));
  await page.goto(`${daemon.url}/`);
  await page.waitForSelector("body[data-state=armed]");
  await page.evaluate(() => window.dashboard.link.call("effect.hold",
    { direction: [0.1, 1, 0.35], current_a: 15, lease_ms: 10000 }));
  await page.waitForTimeout(7000);
  await page.screenshot({ path: `${folder}/dashboard-${name}.png`, fullPage: name === "phone" });
  await page.evaluate(() => window.dashboard.link.call("effect.stop_all"));
  await page.goto(`${daemon.url}/orientation.html`);
  await page.waitForSelector("body[data-state=armed]");
  await page.locator("label", { hasText: "Steady" }).click();
  await page.getByRole("button", { name: "Show up" }).click();
  for (let i = 0; i < 6; ++i) await page.evaluate(() => window.dashboard.ball.turnBy(0.05, 0.12));
  await page.waitForTimeout(1500);
  await page.screenshot({ path: `${folder}/orientation-${name}.png` });
  await page.goto(`${daemon.url}/designer.html`);
  await page.waitForSelector("body[data-state=armed]");
  for (const [t, x, y, level] of [[0, 0.42, 0.52, 0.5], [500, 0.46, 0.4, 1], [1000, 0.53, 0.42, 0.7], [1700, 0.56, 0.58, 0.3]]) {
    await page.locator("[name=time]").fill(String(t));
    await page.locator("[name=level]").fill(String(level));
    const box = await page.locator("#ball").boundingBox();
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  }
  await page.mouse.click(...(await page.evaluate(() => window.dashboard.path.screen(1))));
  // Only currents from after the start of this effect.
  await page.waitForFunction(() => {
    const [levels, currents] = ["levels", "currents"].map((id) => document.getElementById(id).points);
    const ends = (points) => points.getItem(points.length - 1).x;
    return currents.length > 0 && ends(currents) > 0.95 * ends(levels);
  });
  await page.screenshot({ path: `${folder}/designer-${name}.png`, fullPage: name === "phone" });
  await page.goto(racer.url);
  await page.waitForFunction(() => window.racer.ring.last?.kind === "hit" || window.racer.ring.last?.kind === "landing", null, { timeout: 90_000 });
  await page.screenshot({ path: `${folder}/racer-${name}.png` });
}
await browser.close();
await racer.end();
await daemon.end();
