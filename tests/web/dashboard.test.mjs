// SPDX-License-Identifier: MIT
// The dashboard in a browser, against a real daemon: the page shows the state of the ball.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { test } from "node:test";

import { seriousFaults } from "./accessibility.mjs";
import { kDesktop, kPhone } from "./browser.mjs";
import { pageErrors, daemon, keepAddress, open, page, startDaemon, until } from "./dashboard.mjs";
import { kTimeout } from "./timeouts.mjs";

/** The number of colours on the canvas. */
const coloursDrawn = () => page.evaluate(() => {
  const { canvas, renderer, scene, camera } = window.dashboard.ball;
  renderer.render(scene, camera);
  const copy = Object.assign(document.createElement("canvas"), { width: 64, height: 64 });
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0, 64, 64);
  const pixels = new Uint32Array(context.getImageData(0, 0, 64, 64).data.buffer);
  return new Set(pixels).size;
});

test("a connection that drops right after hello is no error of the page, which reconnects", async () => {
  for (const path of ["/", "/orientation.html"]) {
    await page?.context().close();
    let connections = 0;
    await open(path, kDesktop, (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
      const drops = ++connections === 1;
      const server = socket.connectToServer();
      socket.onMessage((text) => {
        if (!drops || !text.includes("device.describe")) return server.send(text);
        server.close();
        return socket.close();
      });
    }));
    assert.equal(connections, 2, path);
  }
});

test("the ball is drawn by WebGL 2, and not blank", async () => {
  await open();
  assert.equal(await page.evaluate(() => window.dashboard.ball.renderer.getContext().constructor.name), "WebGL2RenderingContext");
  assert.ok(await coloursDrawn() > 100);
});

test("a push moves the pins on its side, the arrow points there, and both rest again", async () => {
  await open();
  await page.locator("#duration").fill("2");
  for (const [side, axis, sign] of [["left", 1, 1], ["right", 1, -1], ["front", 0, 1], ["up", 2, 1]]) {
    await page.getByRole("button", { name: side, exact: true }).first().click();
    const out = await (await until(([i, s]) => {
      const { ball } = window.dashboard;
      const pins = ball.pins.map((pin) => ({ at: pin.direction.toArray(), mm: pin.extension })).sort((a, b) => b.mm - a.mm);
      return s * (ball.arrowDirection()?.[i] ?? 0) > 0.98 && pins[0].mm > 0.03 && pins;
    }, [axis, sign])).jsonValue();
    assert.ok(out[0].mm > 0.02, `${side}: ${out[0].mm} mm`);
    for (const pin of out.slice(0, 5)) assert.ok(sign * pin.at[axis] > 0.5, `${side}: ${pin.at}`);
    await until(() => window.dashboard.ball.arrowDirection() === null);
  }
  await until(() => window.dashboard.ball.pins.every((pin) => Math.abs(pin.extension) < 0.002));
  assert.match(await page.textContent("#said"), /^up: 5\.0 A, \d+ mN at pin 0$/);
});

test("keys play, and the kinds of effect have their own sliders", async () => {
  await open();
  await page.keyboard.press("ArrowLeft");
  await until(() => /^left: /.test(document.getElementById("said").textContent));
  await page.getByText("Vibration").click();
  assert.ok(await page.locator("#frequency").isVisible());
  assert.ok(!await page.locator("#speed").isVisible());
  await page.getByText("Circle").click();
  await page.locator("#duration").fill("5");
  await page.keyboard.press("Escape"); // stop must work while a slider has the focus, too
  await page.waitForSelector("body[data-state=disarmed]", kTimeout);
});

test("effects and their clients are listed", async () => {
  await open();
  await page.getByText("Circle").click();
  await page.locator("#duration").fill("10");
  await page.getByRole("button", { name: "axis up" }).click();
  await until(() => document.querySelectorAll("#effects tr").length === 1);
  assert.match(await page.textContent("#effects"), /circle.*pad.*dashboard.*A/);
  await page.getByRole("button", { name: "End my effects" }).click();
  await until(() => document.querySelectorAll("#effects tr").length === 0);
});

test("a pattern is chosen, played towards a side, and listed among what happened", async () => {
  await open();
  await page.getByText("Pattern", { exact: true }).first().click();
  assert.ok(!await page.locator("#duration").isVisible());
  await page.selectOption("[name=pattern]", "heartbeat");
  assert.match(await page.textContent("#pattern-description"), /\w+/);
  await page.evaluate(() => {
    const effects = document.getElementById("effects");
    new MutationObserver(() => {
      window.listed ||= /play.*pad.*dashboard/.test(effects.textContent);
    }).observe(effects, { childList: true, subtree: true, characterData: true });
  });
  await page.getByRole("button", { name: "left", exact: true }).click();
  await until(() => window.listed);
  await until(() => /play of dashboard: completed, 8\d\d ms/.test(document.getElementById("happened").textContent));
  await page.reload();
  await until(() => /play of dashboard: completed, 8\d\d ms/.test(document.getElementById("happened").textContent));
});

test("effects do not displace a trip from the list, and incomplete events do not break it", async () => {
  await open();
  await page.selectOption("[name=fault]", "sensor_open");
  await page.waitForSelector("body[data-state=tripped]", kTimeout);
  await page.evaluate(() => {
    const dispatch = (detail) => window.dashboard.link.dispatchEvent(new CustomEvent("event", { detail }));
    for (let i = 1; i <= 30; ++i) dispatch({ type: "effect_ended", time_ns: i, effect: i, reason: "completed" });
    for (let i = 1; i <= 30; ++i) dispatch({ type: "overrun", time_ns: i });
    dispatch({ type: "derating_started", time_ns: 1 });
    dispatch({ type: "effect_ended", time_ns: 31, effect: 31 });
    dispatch({ type: "state_changed", time_ns: 1, state: "levitating", reason: 7 });
  });
  const shown = () => document.getElementById("happened").textContent;
  await until(() => /levitating · 7/.test(document.getElementById("happened").textContent));
  assert.match(await page.evaluate(shown), /Tripped · The coil thermometer's wire is open · /);
  assert.match(await page.evaluate(shown), /Derated: – A allowed/);
  assert.ok(await page.locator("#happened li").count() <= 16);
});

test("a fault of the simulated ball is shown in words, and cleared", async () => {
  await open();
  await page.selectOption("[name=fault]", "sensor_open");
  await page.waitForSelector("body[data-state=tripped]", kTimeout);
  assert.match(await page.textContent(".state"), /The coil thermometer's wire is open\..*Check the coil thermometer's plug/s);
  await page.selectOption("[name=fault]", "");
  await until(async () => {
    document.getElementById("arm").click();
    return document.body.dataset.state === "armed";
  });
});

test("turning the simulated ball turns the daemon's orientation", async () => {
  await open();
  for (let i = 0; i < 3; ++i) await page.getByRole("button", { name: "turn left" }).click();
  let turned = { z: 0 };
  const deadline = Date.now() + kTimeout.timeout;
  while (Math.abs(turned.z) < 0.3 && Date.now() < deadline) turned = (await daemon.call("device.status")).orientation.quaternion;
  assert.ok(Math.abs(Math.abs(turned.z) - Math.sin(Math.PI / 8)) < 0.01, JSON.stringify(turned));
});

test("the end and the silence of a daemon are reported, and the page reconnects", async () => {
  await keepAddress();
  await open();
  pageErrors.expected = true;
  await daemon.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  assert.match(await page.textContent("#gone"), /The daemon is gone; the board has switched the coils off/);
  await startDaemon();
  await page.waitForSelector("body[data-link=open]", kTimeout);
  assert.match(await page.textContent("#gone"), /The daemon is back/);
  await until(() => document.getElementById("gone").hidden);
  await daemon.end("SIGTERM");
  await until(() => /The daemon is gone \(stop\)/.test(document.getElementById("gone").textContent));
  await startDaemon();
  await page.waitForSelector("body[data-link=open]", kTimeout);
  daemon.process.kill("SIGSTOP");
  await page.waitForSelector("body[data-link=silent]", kTimeout);
  daemon.process.kill("SIGCONT");
  await page.waitForSelector("body[data-link=open]", kTimeout);
});

test("axe finds no serious fault, on a desk and on a phone", async () => {
  for (const [path, device] of [["/", kDesktop], ["/", kPhone], ["/orientation.html", kPhone], ["/designer.html", kPhone]]) {
    await page?.context().close();
    await open(path, device);
    assert.deepEqual(await seriousFaults(page), [], path);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${path} is ${wide} px too wide`);
  }
});

test("a page of another origin, and one under another name, are refused", async () => {
  await open();
  const { port } = daemon;
  pageErrors.expected = true;
  const refused = (url) => page.evaluate((to) => new Promise((resolve) => {
    const socket = new WebSocket(to);
    socket.onopen = () => { socket.close(); resolve(false); };
    socket.onerror = () => resolve(true);
  }), url);
  assert.equal(await refused(`ws://127.0.0.1:${port}/ws`), false);
  // A page of another origin, without a policy.
  const other = createServer((_, response) => response.setHeader("content-type", "text/html").end("<p>game</p>"));
  await new Promise((resolve) => other.listen(0, "127.0.0.1", resolve));
  await page.goto(`http://127.0.0.1:${other.address().port}/`);
  assert.equal(await refused(`ws://127.0.0.1:${port}/ws`), true);
  assert.equal(await refused(`ws://rebound.example:${port}/ws`), true);
  const response = await page.goto(`http://rebound.example:${port}/`);
  assert.equal(response.status(), 421);
  other.closeAllConnections();
  other.close();
});
