// SPDX-License-Identifier: MIT
// The page of the README, unchanged, in Chromium with a simulated daemon.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { Ball } from "../../../clients/js/src/node.js";
import { launch } from "../../web/browser.mjs";
import { Daemon } from "../../web/daemon.mjs";
import { example, installed } from "./installed.mjs";
import { servePages } from "./pages.mjs";

const TIMEOUT_MS = 60_000;
let game;
let pages;
let daemon;
let browser;

before(async () => {
  game = installed();
  fs.writeFileSync(path.join(game.folder, "index.html"), example("html"));
  pages = await servePages({ "/": game.folder });
  daemon = await Daemon.start({ config: { http: { allow_origins: [pages.url] } } });
  // The page connects to the daemon's default port; the test's daemon has a free one.
  browser = await launch([`MAP 127.0.0.1:7587 127.0.0.1:${daemon.port}`]);
});

after(async () => {
  await browser?.close();
  await daemon?.end();
  pages?.close();
  game?.remove();
});

test("the page of the README plays a push when its button is pressed", async () => {
  const observer = await Ball.connect({ address: `127.0.0.1:${daemon.tcp}`, timeoutMs: TIMEOUT_MS });
  const events = observer.events(["effect_started"], { scope: "all" });
  const started = events.next();
  await observer.ping();
  const page = await browser.newPage();
  const websocket = page.waitForEvent("websocket", { timeout: TIMEOUT_MS });
  await page.goto(`${pages.url}/`);
  await (await websocket).waitForEvent("framereceived", { timeout: TIMEOUT_MS }); // the response to hello
  await page.waitForFunction(() => document.querySelector("button").onclick, null, { timeout: TIMEOUT_MS });
  await page.getByRole("button", { name: "Push" }).click();
  assert.equal((await started).value.type, "effect_started");
  observer.close();
});

test("a page of an origin that is not allowed gets an error", async () => {
  const foreignPages = await servePages({ "/": game.folder });
  const page = await browser.newPage();
  const failed = page.waitForEvent("pageerror", { timeout: TIMEOUT_MS });
  await page.goto(`${foreignPages.url}/`);
  assert.match((await failed).message, /the daemon does not run: ws:.*this page's origin is not allowed/);
  foreignPages.close();
});
