// SPDX-License-Identifier: MIT
// The stop button of the dashboard and of the orientation page: it stops, or reports visibly and at once that it did
// not.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop, kPhone } from "./browser.mjs";
import { pageErrors, daemon, keepAddress, open, page, startDaemon, until } from "./dashboard.mjs";
import { kTimeout } from "./timeouts.mjs";

test("the stop button zeroes the coils and confirms it, and they can be driven after arming", async () => {
  await open();
  await page.getByText("Circle").click();
  await page.locator("#duration").fill("10");
  await page.getByRole("button", { name: "axis up" }).click();
  await until(() => /^[1-9].* of/.test(document.getElementById("current").textContent));
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
  await until(() => /^0\.0 A/.test(document.getElementById("current").textContent));
  const status = await daemon.call("device.status");
  assert.equal(status.reason, "emergency_stop");
  assert.ok(Math.hypot(...status.current_a) < 0.1);
  assert.match(await page.textContent(".state"), /Somebody pressed stop\..*hedgehogctl arm/s);
  await page.getByRole("button", { name: "Arm the ball" }).click();
  await until(() => ["armed", ""].includes(document.body.dataset.state) || document.querySelector("#said.bad"));
  assert.equal(await page.textContent("#said"), "armed");
  await page.waitForSelector("body[data-state=armed]", kTimeout);
});

test("stop reaches the daemon while the page's connection hangs", async () => {
  await open();
  await page.evaluate(() => { window.dashboard.link.socket.send = () => {}; });
  await page.keyboard.press("Escape");
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
});

/** On the screen, and not covered. */
const inSight = (selector) => page.evaluate((which) => {
  const box = document.querySelector(which).getBoundingClientRect();
  const over = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  return box.height > 0 && box.top >= 0 && box.left >= 0 && box.bottom <= innerHeight && box.right <= innerWidth &&
    over.matches(which);
}, selector);

for (const [path, device, where] of [["/", kDesktop, "a desk"], ["/", kPhone, "a phone"], ["/orientation.html", kPhone, "the orientation page"]]) {
  test(`a daemon that hangs does not confirm the stop: the warning is in sight on ${where}, until it has stopped after all`, async () => {
    await open(path, device);
    pageErrors.expected = true;
    daemon.process.kill("SIGSTOP");
    await page.getByRole("button", { name: "Stop", exact: true }).click();
    await until(() => document.getElementById("unstopped")?.hidden === false);
    assert.match(await page.textContent("#unstopped"), /does not confirm the stop.*pull the plug/);
    assert.ok(await inSight("#unstopped"));
    assert.ok(await inSight("#stop"));
    assert.equal(await page.locator("#stop.pressed").count(), 0);
    daemon.process.kill("SIGCONT");
    await page.waitForSelector("body[data-state=disarmed]", kTimeout);
    await until(() => document.getElementById("unstopped").hidden && /^coils off/i.test(document.getElementById("said").textContent));
  });
}

test("space stops after the mouse has pressed something, and presses it no second time", async () => {
  await open();
  const spaceStops = async () => {
    await page.keyboard.press("Space");
    await page.waitForSelector("body[data-state=disarmed]", kTimeout);
    await daemon.call("device.arm");
    await page.waitForSelector("body[data-state=armed]", kTimeout);
    await until(() => !document.querySelector("[data-direction=left]").disabled);
  };
  for (const used of ["text=Vibration", "[data-direction=left]", "[data-turn='-1,0']", "[name=turn]"]) {
    await page.locator(used).first().click();
    await until(() => document.activeElement === document.body);
    await spaceStops();
  }
  assert.ok(await page.isChecked("[name=turn]"));
  const metrics = await (await fetch(`${daemon.url}/metrics`)).text();
  const vibrations = [...metrics.matchAll(/effects_total\{[^}]*"effect\.vibrate"[^}]*\} (\d+)/g)];
  assert.equal(vibrations.reduce((sum, [, count]) => sum + Number(count), 0), 1);
});

test("space belongs to the control that has the focus; escape always stops", async () => {
  await open();
  const to = async (selector) => {
    for (let steps = 0; !await page.evaluate((which) => document.activeElement.matches(which), selector); ++steps) {
      assert.ok(steps < 60, `${selector} is not reached`);
      await page.keyboard.press("Tab");
    }
  };
  await to("[data-direction=left]");
  await page.keyboard.press("Space");
  await until(() => /^left: /.test(document.getElementById("said").textContent));
  for (const control of ["#strength", "nav a"]) {
    await to(control);
    await page.keyboard.press("Space");
    // A request that the daemon receives after the stop request.
    await page.evaluate(() => window.dashboard.link.call("ping"));
    assert.equal((await daemon.call("device.status")).state, "armed", control);
    await page.keyboard.press("Escape");
    await page.waitForSelector("body[data-state=disarmed]", kTimeout);
    await daemon.call("device.arm");
    await page.waitForSelector("body[data-state=armed]", kTimeout);
    await until(() => !document.querySelector("[data-direction=left]").disabled);
  }
});

test("space stops what a click began to show on the orientation page", async () => {
  await open("/orientation.html");
  await page.getByText("Steady, 5 A").click();
  await page.getByRole("button", { name: "Show up" }).click();
  await until(() => window.dashboard.ball.arrowDirection() !== null);
  await page.keyboard.press("Space");
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
});

test("an unconfirmed stop is shown until a daemon is connected", async () => {
  await keepAddress();
  await open();
  pageErrors.expected = true;
  await daemon.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  await page.keyboard.press("Escape");
  await until(() => document.getElementById("unstopped")?.hidden === false);
  await startDaemon();
  await page.waitForSelector("body[data-link=open]", kTimeout);
  await until(() => document.getElementById("unstopped").hidden);
});

test("a response that refuses the stop does not confirm it", async () => {
  const refusal = (text) => JSON.stringify({ jsonrpc: "2.0", id: JSON.parse(text).id, error: { code: -32603, message: "no", data: { name: "internal" } } });
  // On a busy machine the page may need more than one connection to open.
  let stopping = false;
  let refused = 0;
  await open("/", kDesktop, (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
    if (stopping) {
      socket.onMessage((text) => {
        refused += text.includes("emergency_stop") ? 1 : 0;
        socket.send(refusal(text));
      });
    } else {
      const server = socket.connectToServer();
      socket.onMessage((text) => text.includes("emergency_stop") || server.send(text));
    }
  }));
  stopping = true;
  await page.keyboard.press("Escape");
  await until(() => document.getElementById("unstopped")?.hidden === false);
  assert.equal(refused, 1);
  assert.equal(await page.getAttribute("body", "data-state"), "armed");
});
