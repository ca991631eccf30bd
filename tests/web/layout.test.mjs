// SPDX-License-Identifier: MIT
// The dashboard at common screen widths: nothing overflows, the essential parts are on a phone's first screen, and
// controls keep their positions.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop, kPhone } from "./browser.mjs";
import { pageErrors, daemon, open, page, startDaemon, until } from "./dashboard.mjs";
import { kTimeout } from "./timeouts.mjs";

const kSmallPhone = { ...kPhone, viewport: { width: 360, height: 640 } };
const kWidths = [320, 360, 390, 768, 899, 900, 1000, 1100, 1270, 1280, 1600];

/** Elements that overflow their card or the page. */
function findOverflowing() {
  const out = [];
  for (const card of document.querySelectorAll("section")) {
    const box = card.getBoundingClientRect();
    for (const child of card.querySelectorAll("*")) {
      const inner = child.getBoundingClientRect();
      const hidden = !child.checkVisibility() || inner.width <= 1 || child.closest(".unseen, .picture, .uplot, input");
      if (!hidden && (inner.right > box.right + 0.5 || inner.left < box.left - 0.5)) out.push(`${card.className}: ${child.tagName} ${child.id} ${child.textContent.trim().slice(0, 30)}`);
      const clipped = child.matches("button, label") && child.scrollWidth > child.clientWidth + 1;
      if (!hidden && clipped) out.push(`${card.className}: text of ${child.textContent.trim()}`);
    }
  }
  const wide = document.documentElement.scrollWidth - innerWidth;
  return wide > 0 ? [...out, `the page, by ${wide} px`] : out;
}

/** The charts follow a new width some frames later, on a busy machine many. */
async function overflowing() {
  await page.waitForFunction(`(${findOverflowing})().length === 0`, null, kTimeout).catch(() => {});
  return page.evaluate(findOverflowing);
}

test("nothing sticks out of its card at any width", async () => {
  await open();
  await page.evaluate(() => { document.querySelector("#windings").open = true; });
  for (const width of kWidths) {
    await page.setViewportSize({ width, height: 800 });
    for (const kind of ["pulse", "circle", "vibrate", "pattern"]) {
      await page.locator(`[name=kind][value=${kind}]`).check({ force: true });
      assert.deepEqual(await overflowing(), [], `${width} px, ${kind}`);
    }
  }
});

/** On the screen without scrolling, and not covered. */
const onScreen = (selector) => page.evaluate((which) => {
  const element = document.querySelector(which);
  const box = element.getBoundingClientRect();
  const over = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
  return box.height > 0 && box.top >= 0 && box.left >= 0 && box.bottom <= innerHeight && box.right <= innerWidth && element.contains(over);
}, selector);

for (const [name, device] of [["a phone", kPhone], ["a small phone", kSmallPhone]]) {
  test(`temperature, state and stop are on the first screen of ${name}`, async () => {
    await open("/", device);
    for (const what of ["#state", "#hottest", "#stop"]) assert.ok(await onScreen(what), what);
    await daemon.call("device.emergency_stop");
    await page.waitForSelector("body[data-state=disarmed]", kTimeout);
    for (const what of ["#state", "#remedy", "#hottest", "#stop", "#arm"]) assert.ok(await onScreen(what), what);
  });
}

/** The positions of everything that can be pressed. */
const places = () => page.evaluate(() => Object.fromEntries(
  [...document.querySelectorAll(".pad button, .pad input, #stop, #arm, #simulator button, summary, nav a")].map((control) => {
    const { x, y, width, height } = control.getBoundingClientRect();
    return [control.id || control.dataset.direction || control.value || control.textContent || control.name, [x, y, width, height].map(Math.round)];
  })));

for (const [name, device] of [["a desk", kDesktop], ["a narrow desk", { viewport: { width: 1000, height: 800 } }], ["a phone", kPhone], ["a small phone", kSmallPhone]]) {
  test(`stop moves no control on ${name}, and neither does an answer`, async () => {
    await open("/", device);
    const before = await places();
    await page.locator("[data-direction=left]").click();
    await until(() => /^left: /.test(document.getElementById("said").textContent));
    const scrolled = await page.evaluate(() => scrollY);
    await page.evaluate(() => scrollTo(0, 0));
    assert.deepEqual(await places(), before, `after an answer (scrolled by ${scrolled})`);
    await page.getByRole("button", { name: "Stop", exact: true }).click();
    await page.waitForSelector("body[data-state=disarmed]", kTimeout);
    await until(() => /^coils off/i.test(document.getElementById("said").textContent));
    assert.deepEqual(await places(), before, "after stop");
  });
}

test("the end of a daemon moves no control", async () => {
  await open("/", kPhone);
  const before = await places();
  pageErrors.expected = true;
  await daemon.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  assert.deepEqual(await places(), before);
});

test("a ball that is not armed has its pad disabled, whatever is pressed", async () => {
  await open();
  const buttons = page.locator(".sides button");
  assert.equal(await buttons.first().isDisabled(), false);
  await daemon.call("device.emergency_stop");
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
  for (const button of await buttons.all()) assert.ok(await button.isDisabled());
  assert.ok(await page.locator("#strength").isDisabled());
  assert.equal(await page.textContent("#ask"), "Disarmed: arm the ball to play.");
  await page.keyboard.press("ArrowLeft");
  await until(() => document.getElementById("said").textContent === "Disarmed: arm the ball to play.");
  await daemon.call("device.arm");
  await until(() => !document.querySelector(".sides button").disabled);
});

test("the pad is disabled while there is no daemon", async () => {
  await open();
  pageErrors.expected = true;
  await daemon.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  assert.ok(await page.locator("[data-direction=left]").isDisabled());
});

test("the buttons of a circle name an axis, and a response does not change them", async () => {
  await open();
  assert.equal(await page.textContent("#ask"), "Push towards");
  await page.getByText("Circle").click();
  assert.equal(await page.textContent("#ask"), "Turn round this axis");
  const words = () => page.locator(".sides button").allTextContents();
  const before = await words();
  assert.deepEqual(before, ["axis up", "axis front", "axis left", "axis right", "axis back", "axis down"]);
  await page.getByRole("button", { name: "axis left" }).click();
  await until(() => /^axis left: /.test(document.getElementById("said").textContent));
  assert.deepEqual(await words(), before);
  assert.equal(await page.locator("[data-direction=left]").isEnabled(), true);
});

test("no sentence has the name of an error in it", async () => {
  await daemon.end();
  await startDaemon();
  await open();
  // Rejected by the daemon, not by the page, which has not been notified yet that the ball is disarmed.
  await page.evaluate(() => {
    const { link } = window.dashboard;
    link.call = (call => (method, params) => (method === "effect.pulse"
      ? call("device.emergency_stop").then(() => call(method, params)) : call(method, params)))(link.call.bind(link));
  });
  await page.locator("[data-direction=left]").click();
  await until(() => document.querySelector("#said.bad"));
  assert.match(await page.textContent("#said"), /^The ball is disarmed/);
  assert.doesNotMatch(await page.textContent("#said"), /not_armed|-32/);
});

test("the reason of a reduction is shown in words, and so is that of a refused page", async () => {
  let refuses = false;
  pageErrors.expected = true;
  await open("/", kDesktop, (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
    const server = socket.connectToServer();
    socket.onMessage((text) => {
      const { id, method } = JSON.parse(text);
      if (!refuses || method !== "hello") return server.send(text);
      const error = { code: -32001, message: "busy: 64 clients are connected", data: { name: "busy" } };
      return socket.send(JSON.stringify({ jsonrpc: "2.0", id, error }));
    });
    server.onMessage((text) => socket.send(text.replace('"limited_by":null', '"limited_by":"thermal"')));
  }));
  await page.locator("[data-direction=left]").click();
  await until(() => /, limited by heat$/.test(document.getElementById("said").textContent));
  refuses = true;
  await page.evaluate(() => window.dashboard.link.socket.close());
  await until(() => /64 clients/.test(document.getElementById("gone").textContent));
  assert.match(await page.textContent("#gone"), /^The daemon is gone \(64 clients are connected\)/);
});

/** Without the daemon's own events: on a busy machine its loop skips ticks, and it loses the orientation. */
const openWithoutEvents = () => open("/", kDesktop, (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
  const server = socket.connectToServer();
  const histories = new Set();
  socket.onMessage((text) => {
    const { id, method } = JSON.parse(text);
    if (method === "events.history") histories.add(id);
    server.send(text);
  });
  server.onMessage((text) => {
    const { id, method } = JSON.parse(text);
    if (histories.delete(id)) socket.send(JSON.stringify({ jsonrpc: "2.0", id, result: { events: [] } }));
    else if (method !== "event") socket.send(text);
  });
}));

test("recurring events are one line, and displace no other", async () => {
  await openWithoutEvents();
  await page.evaluate(() => {
    const dispatch = (detail) => window.dashboard.link.dispatchEvent(new CustomEvent("event", { detail }));
    dispatch({ type: "derating_started", time_ns: 1, limit_a: 9 });
    for (let i = 1; i <= 40; ++i) dispatch({ type: "overrun", time_ns: i, skipped: 2 });
  });
  await until(() => /80 ticks of the loop skipped, 40 times/.test(document.getElementById("happened").textContent));
  assert.match(await page.textContent("#happened"), /Derated: 9\.0 A allowed/);
  assert.equal(await page.locator("#happened li", { hasText: "of the loop" }).count(), 1);
});

test("a rejected measurement is a line of its winding, also of several in one tick and beside other recurring events", async () => {
  await openWithoutEvents();
  await page.evaluate(() => {
    const dispatch = (detail) => window.dashboard.link.dispatchEvent(new CustomEvent("event", { detail }));
    for (const time of [1, 2]) {
      for (const coil of [0, 1, 2])
        dispatch({ type: "measurement_rejected", time_ns: time, disagreement: { coil, between: ["resistance", "heat_balance"] } });
    }
    dispatch({ type: "overrun", time_ns: 3, skipped: 2 });
    dispatch({ type: "orientation_lost", time_ns: 4 });
  });
  await until(() => /Orientation lost/.test(document.getElementById("happened").textContent));
  for (const winding of ["x", "y", "z"]) {
    const line = page.locator("#happened li", { hasText: `Measurement rejected: winding ${winding}: resistance, heat balance, 2 times` });
    assert.equal(await line.count(), 1, winding);
  }
});

test("repeated derating displaces no emergency stop", async () => {
  await openWithoutEvents();
  await page.evaluate(() => {
    const dispatch = (detail) => window.dashboard.link.dispatchEvent(new CustomEvent("event", { detail }));
    dispatch({ type: "state_changed", time_ns: 1, state: "disarmed", reason: "emergency_stop", client: "a phone" });
    for (let i = 1; i <= 10; ++i) {
      dispatch({ type: "derating_started", time_ns: 2 * i, limit_a: 9 });
      dispatch({ type: "derating_ended", time_ns: 2 * i + 1, limit_a: 15 });
    }
  });
  await until(() => /Full strength again: 15\.0 A allowed/.test(document.getElementById("happened").textContent));
  assert.match(await page.textContent("#happened"), /Disarmed · Somebody pressed stop · a phone/);
  assert.equal(await page.locator("#happened li", { hasText: /Derated|Full strength/ }).count(), 2);
});

test("one tick is one tick", async () => {
  await openWithoutEvents();
  await page.evaluate(() => window.dashboard.link.dispatchEvent(
    new CustomEvent("event", { detail: { type: "overrun", time_ns: 1, skipped: 1 } })));
  await until(() => /1 tick of the loop skipped/.test(document.getElementById("happened").textContent));
});
