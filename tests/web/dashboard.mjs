// SPDX-License-Identifier: MIT
// A separate daemon for each test, and the pages that it serves, open in one browser.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach } from "node:test";

import { Address } from "./address.mjs";
import { PageErrors, kDesktop, launch, newPage } from "./browser.mjs";
import { Daemon } from "./daemon.mjs";
import { kTimeout } from "./timeouts.mjs";

export let daemon;
export let page;
export const pageErrors = new PageErrors();
let address = null;
let browser;

before(async () => { browser = await launch(); });
after(async () => { await browser?.close(); });
beforeEach(async () => { await startDaemon(); });
afterEach(async () => {
  await page?.context().close();
  await daemon.end();
  await address?.end();
  address = null;
  assert.deepEqual(pageErrors.take(), []);
});

export async function startDaemon(options) {
  daemon = await Daemon.start(options);
  address?.leadTo(daemon);
}

/** Pages opened from now on use an address that the next daemon of this test will have, too. */
export async function keepAddress() {
  address = await Address.listen();
  address.leadTo(daemon);
}

/** `prepare(page)` is called before anything is loaded. */
export async function open(path = "/", device = kDesktop, prepare = () => {}) {
  page = await newPage(browser, device);
  page.setDefaultTimeout(kTimeout.timeout);
  pageErrors.watch(page);
  await prepare(page);
  await page.goto((address ?? daemon).url + path);
  await page.waitForSelector("body[data-link=open][data-state=armed]", kTimeout);
  // What is under the pointer is known once the ball has been drawn.
  await page.waitForFunction(() => {
    const { pins, renderer } = window.dashboard.ball;
    return pins.length === 86 && renderer.info.render.frame > 0;
  }, null, kTimeout);
}

/** What a page that is being opened will send, in an array that grows. */
export function messagesOf(opened) {
  const sent = [];
  opened.on("websocket", (socket) => socket.on("framesent", ({ payload }) => sent.push(...[JSON.parse(payload)].flat())));
  return sent;
}

export const until = (condition, argument) => page.waitForFunction(condition, argument, kTimeout);
