// SPDX-License-Identifier: MIT
// A separate game for each test, optionally with a daemon, and its page, open in one browser.
import assert from "node:assert/strict";
import { after, afterEach, before } from "node:test";

import { Address } from "./address.mjs";
import { PageErrors, launch, newPage } from "./browser.mjs";
import { Daemon } from "./daemon.mjs";
import { kTimeout } from "./timeouts.mjs";
import { Racer } from "./racer.mjs";

/** Rendered in software: a few pixels are enough to detect a picture. */
export const kSmall = { viewport: { width: 640, height: 420 } };
export const pageErrors = new PageErrors();
export let browser;
export let racer;
export let daemon;
export let page;
let address = null;

before(async () => { browser = await launch(); });
after(async () => { await browser?.close(); });
afterEach(async () => {
  await page?.context().close();
  await racer?.end();
  await daemon?.end();
  await address?.end();
  page = racer = daemon = address = null;
  assert.deepEqual(pageErrors.take(), []);
});

export async function startDaemon(options) {
  daemon = await Daemon.start(options);
}

export async function startRacer(options) {
  racer = await Racer.start(options);
  address?.leadTo(racer);
}

/** Pages opened from now on use an address that the next game of this test will have, too. */
export async function keepAddress() {
  address = await Address.listen();
  address.leadTo(racer);
}

/** An empty page. */
export async function openBlank(device = kSmall) {
  page = await newPage(browser, device);
}

export async function open(device = kSmall) {
  await openBlank(device);
  page.setDefaultTimeout(kTimeout.timeout);
  pageErrors.watch(page);
  await page.goto((address ?? racer).url);
  await page.waitForSelector("body[data-link=open]", kTimeout);
  await page.waitForFunction(() => window.racer.frame > 1, null, kTimeout);
}

export const until = (condition, argument) => page.waitForFunction(condition, argument, kTimeout);
export const at = () => page.evaluate(() => window.racer.scene().car.at);
