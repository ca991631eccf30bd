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
let page;

before(async () => {
  pages = await servePages({ "/library/": folder("../../../clients/js/src/"), "/": folder("./") });
  browser = await launch();
  page = await browser.newPage();
});

after(async () => {
  await browser.close();
  pages.close();
});

/** Like Driver, in the page. Each case loads the page again, which ends the connections of the case before; a new page takes far
 * longer. */
async function driverInPage() {
  await page.goto(`${pages.url}/driver.html`);
  return {
    open: (options) => page.evaluate((given) => window.driver.open(given), options),
    do: (step) => page.evaluate((given) => window.driver.do(given), step),
    close: () => page.evaluate(() => window.driver.close()),
  };
}

addCases("JavaScript, browser", driverInPage, (port) => `ws://127.0.0.1:${port}/ws`, ["--websocket"]);
