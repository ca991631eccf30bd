// SPDX-License-Identifier: MIT
// The pages of a daemon that is reached by TLS: without a token nothing is shown and nothing is done.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";

import { PageErrors, kDesktop, launch, newPage } from "./browser.mjs";
import { Daemon } from "./daemon.mjs";
import { kTimeout } from "./timeouts.mjs";

const pageErrors = new PageErrors();
let browser;
let daemon;
let tokens;
let page;

before(async () => { browser = await launch(); });
after(async () => { await browser?.close(); });
beforeEach(async () => {
  daemon = await Daemon.start({
    config: { http: { listen: "tls://127.0.0.1:0" } },
    before: (ball) => {
      tokens = { play: ball.token("add", "arcade", "--role", "play"), operate: ball.token("add", "owner", "--role", "operate") };
      ball.token("certificate");
    },
  });
});
afterEach(async () => {
  await page?.context().close();
  await daemon.end();
  assert.deepEqual(pageErrors.take(), []);
});

/** `prepare(page)` is called before anything is loaded. */
async function open(path = "/", prepare = () => {}) {
  page = await newPage(browser, { ...kDesktop, ignoreHTTPSErrors: true });
  page.setDefaultTimeout(kTimeout.timeout);
  pageErrors.watch(page);
  await prepare(page);
  await page.goto(daemon.url + path);
  await page.waitForSelector("body[data-link=locked]", kTimeout);
}
async function show(token) {
  await page.locator("#token input").fill(token);
  await page.getByRole("button", { name: "Connect" }).click();
}
const opened = () => page.waitForSelector("body[data-link=open][data-state=armed]", kTimeout);

for (const path of ["/", "/designer.html", "/orientation.html"]) {
  test(`${path} asks for a token, and works with it`, async () => {
    await open(path);
    assert.ok(await page.locator("#token").isVisible());
    await show(tokens.operate);
    await page.waitForSelector("body[data-link=open]", kTimeout);
    assert.ok(await page.locator("#token").isHidden());
  });
}

test("a wrong token is reported, and a right one accepted after it; a reload prompts no more", async () => {
  await open();
  await show("hht_guess");
  await page.getByText("The token is unknown or revoked.").waitFor(kTimeout);
  await show(tokens.play);
  await opened();
  assert.match(await page.textContent("#version"), /role play/);
  await page.reload();
  await opened();
});

test("a right token that is refused for others' wrong ones is sent again", async () => {
  const refusal = { code: -32003, message: "token: wait", data: { name: "unauthorized", retry_after_ms: 3000 } };
  const shown = [];
  await open("/", async (fresh) => {
    await fresh.addInitScript((token) => sessionStorage.setItem("hedgehog-token", token), tokens.play);
    await fresh.routeWebSocket("**/ws", (socket) => {
      const server = socket.connectToServer();
      socket.onMessage((text) => {
        const { id, method, params } = JSON.parse(text);
        if (method !== "hello" || shown.push(params.token) > 1) return server.send(text);
        return socket.send(JSON.stringify({ jsonrpc: "2.0", id, error: refusal }));
      });
    });
  });
  assert.match(await page.textContent("#token-problem"), /Too many wrong tokens/);
  await opened();
  assert.deepEqual(shown.slice(0, 2), [tokens.play, tokens.play]);
});

test("a revoked token ends the page's connection, and is prompted for again", async () => {
  await open();
  await show(tokens.play);
  await opened();
  pageErrors.expected = true;
  daemon.token("revoke", "arcade");
  daemon.process.kill("SIGHUP");
  await page.waitForSelector("body[data-link=locked]", kTimeout);
  await page.getByText("The token is unknown or revoked.").waitFor(kTimeout);
});

test("the emergency stop reaches the daemon while the page's connection hangs", async () => {
  await open();
  await show(tokens.play);
  await opened();
  await page.evaluate(() => { window.dashboard.link.socket.send = () => {}; });
  await page.keyboard.press("Escape");
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
});

test("the recording of a trip is saved by a click", async () => {
  await open();
  await show(tokens.operate);
  await opened();
  await page.selectOption("[name=fault]", "sensor_open");
  await page.waitForSelector("body[data-state=tripped]", kTimeout);
  const link = page.locator("#happened a");
  await link.first().waitFor(kTimeout);
  const [download] = await Promise.all([page.waitForEvent("download"), link.first().click()]);
  assert.equal(download.suggestedFilename(), "trip-0001.hhr");
  assert.ok(readFileSync(await download.path()).equals(readFileSync(join(daemon.home, "state/hedgehog/trip-0001.hhr"))));
});

test("a recording that cannot be downloaded is reported", async () => {
  await open();
  await show(tokens.operate);
  await opened();
  await page.selectOption("[name=fault]", "sensor_open");
  const link = page.locator("#happened a");
  await link.first().waitFor(kTimeout);
  pageErrors.expected = true;
  await page.route("**/recordings/*", (route) => route.fulfill({ status: 404 }));
  await link.first().click();
  await page.getByText("trip-0001.hhr was not downloaded: the daemon answers 404").waitFor(kTimeout);
});
