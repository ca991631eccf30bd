// SPDX-License-Identifier: MIT
// Runs conformance.json on the JavaScript library in a page: Chromium, over WebSocket.
import { after, before } from "node:test";
import { fileURLToPath } from "node:url";
import { launch } from "../../web/browser.mjs";
import { addCases } from "./cases.mjs";
import { servePages } from "./pages.mjs";

const folder = (name) => fileURLToPath(new URL(name, import.meta.url));
let browser;
let pages;

before(async () => {
  pages = await servePages({ "/library/": folder("../../../clients/js/src/"), "/": folder("./") });
  browser = await launch();
});

after(async () => {
  await browser.close();
  pages.close();
});

/** Like Driver, in a separate page. */
async function driverInPage() {
  const page = await browser.newPage();
  await page.goto(`${pages.url}/driver.html`);
  await page.waitForFunction(() => window.driver);
  return {
    open: (options) => page.evaluate((given) => window.driver.open(given), options),
    do: (step) => page.evaluate((given) => window.driver.do(given), step),
    async close() {
      await page.evaluate(() => window.driver.close());
      await page.close();
    },
  };
}

addCases("JavaScript, browser", driverInPage, (port) => `ws://127.0.0.1:${port}/ws`, ["--websocket"]);
