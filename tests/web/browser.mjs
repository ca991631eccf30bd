// SPDX-License-Identifier: MIT
// Debian's Chromium, headless, with WebGL in software. Nothing is downloaded.
import { existsSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const { chromium } = require("playwright-core");

const kChromium = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);

export const kDesktop = { viewport: { width: 1360, height: 860 } };
export const kPhone = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

/** `names`: further host resolver rules of Chromium. */
export function launch(names = []) {
  return chromium.launch({
    executablePath: kChromium,
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader",
      // A fake microphone that beeps, with permission for each page.
      "--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream", `--host-resolver-rules=${["MAP *.example 127.0.0.1", ...names].join(", ")}`],
  });
}

/** Sixty frames a second, drawn in software, take a whole processor. With five the racing page draws as on a slow machine:
 * coarser, and its camera follows later. */
function drawSeldom() {
  const next = window.requestAnimationFrame;
  let drawnAt = -Infinity;
  window.requestAnimationFrame = (draw) => setTimeout(next, Math.max(0, drawnAt + 200 - performance.now()), (now) => {
    drawnAt = performance.now();
    draw(now);
  });
}

/** An empty page in a context of its own, which draws at most five frames a second. */
export async function newPage(browser, device) {
  const context = await browser.newContext(device);
  await context.addInitScript(drawSeldom);
  return context.newPage();
}

/** Errors on the pages of a test: uncaught errors always, the browser's console errors unless they are expected. */
export class PageErrors {
  errors = [];
  /** For a test that kills the page's server, or has its requests rejected. */
  expected = false;

  watch(page) {
    page.on("pageerror", (error) => this.errors.push(error.stack));
    page.on("console", (message) => {
      if (message.type() === "error" && !this.expected) this.errors.push(message.text());
    });
  }

  /** Returns the errors of the test that ended, and clears the list. */
  take() {
    const { errors } = this;
    this.errors = [];
    this.expected = false;
    return errors;
  }
}
