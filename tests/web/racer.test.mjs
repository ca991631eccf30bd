// SPDX-License-Identifier: MIT
// The racing game in a browser: events of the race are shown on its page and played on a real daemon's ball.
import assert from "node:assert/strict";
import { test } from "node:test";

import { seriousFaults } from "./accessibility.mjs";
import { kDesktop, kPhone, newPage } from "./browser.mjs";
import { eventually, kTimeout } from "./timeouts.mjs";
import { at, browser, pageErrors, daemon, keepAddress, kSmall, open, openBlank, page, racer, startDaemon, startRacer, until } from "./race.mjs";

test("the race is drawn by WebGL 2, and the built-in driver's car moves", async () => {
  await startRacer({ more: ["--driver"] });
  await open();
  const picture = await page.evaluate(() => {
    const { renderer, camera, stage } = window.racer;
    renderer.render(stage().root, camera);
    const copy = Object.assign(document.createElement("canvas"), { width: 64, height: 64 });
    const context = copy.getContext("2d");
    context.drawImage(renderer.domElement, 0, 0, 64, 64);
    const pixels = new Uint32Array(context.getImageData(0, 0, 64, 64).data.buffer);
    return { colours: new Set(pixels).size, kind: renderer.getContext().constructor.name };
  });
  assert.equal(picture.kind, "WebGL2RenderingContext");
  assert.ok(picture.colours > 100, `${picture.colours} colours`);
  const start = await at();
  await until((from) => {
    const { position } = window.racer.stage().car.body;
    return Math.hypot(position.x - from[0], position.y - from[1]) > 15 && Number(document.getElementById("speed").textContent) > 10;
  }, start);
  assert.ok(await page.isChecked("[value=driver]"));
  assert.match(await page.textContent("#strength"), /^No ball/);
  // Without a ball the effects are shown, too, without amperes.
  await until(() => /^(Landing|Skidding|Hit): .*, \d+ %$/.test(document.getElementById("felt").textContent));
});

test("keys drive, pause and reset the car, and released keys stop driving it", async () => {
  await startRacer();
  await open();
  const start = await at();
  await page.keyboard.down("ArrowUp");
  await until(() => window.racer.scene().throttle === 1 && window.racer.scene().speed_mps > 3);
  await page.keyboard.down("KeyA");
  await until(() => window.racer.scene().steer < -0.5);
  await page.keyboard.up("KeyA");
  await page.keyboard.up("ArrowUp");
  await until(() => window.racer.scene().throttle === 0 && window.racer.scene().steer === 0);
  await page.keyboard.press("p");
  await until(() => window.racer.scene().paused && !document.getElementById("paused").hidden);
  const still = await at();
  // The game sends its state while it is paused, too.
  await until(() => (window.scenesSeen ??= new Set()).add(window.racer.scene()).size > 10);
  assert.deepEqual(await at(), still);
  await page.getByRole("button", { name: "Pause" }).click();
  await until(() => !window.racer.scene().paused);
  assert.ok(Math.hypot(still[0] - start[0], still[1] - start[1]) > 1);
  await page.keyboard.press("r");
  await until(() => Math.abs(window.racer.scene().speed_mps) < 0.5);
});

test("a page that closes releases its keys", async () => {
  await startRacer();
  await open();
  const other = await newPage(browser, kSmall);
  await other.goto(racer.url);
  await other.waitForSelector("body[data-link=open]", kTimeout);
  await other.keyboard.down("KeyW");
  await until(() => window.racer.scene().throttle === 1);
  await other.context().close();
  await until(() => window.racer.scene().throttle === 0);
});

test("a hit is seen on the ring and felt on the ball, and costs of its budget", async () => {
  await startDaemon();
  await startRacer({ daemon, more: ["--driver"] });
  await open();
  await until(() => document.body.dataset.ball === "armed" && /°C/.test(document.getElementById("strength").textContent));
  const meter = () => page.getAttribute("#budget", "aria-valuenow").then(Number);
  const cool = await meter();
  assert.ok(cool > 80, `${cool} %`);
  assert.match(await page.textContent("#help"), /Turn the simulated ball/);
  // Full throttle and full steering lock: the car hits the wall beside the start.
  await page.getByText("Keys", { exact: true }).click();
  await page.keyboard.down("ArrowUp");
  await page.keyboard.down("ArrowLeft");
  const mark = await (await until(() => {
    const { ring } = window.racer;
    if (ring.last?.kind !== "hit") return false;
    ring.draw();
    const push = document.getElementById("push");
    const [x, y] = ring.last.direction;
    const words = document.getElementById("felt").textContent;
    return Number(push.getAttribute("r")) > 3 && { x, y, cx: Number(push.getAttribute("cx")), cy: Number(push.getAttribute("cy")), words };
  })).jsonValue();
  assert.ok(Math.hypot(mark.cx + 38 * mark.y, mark.cy + 38 * mark.x) < 1, JSON.stringify(mark));
  assert.match(mark.words, /^Hit: .*, \d+ %, \d+\.\d A$/);
  await page.keyboard.up("ArrowLeft");
  // The daemon has played the effect and counts it for the client.
  const pulsed = async () => /effects_total\{[^}]*"effect\.pulse"[^}]*\} [1-9]/.test(await (await fetch(`${daemon.url}/metrics`)).text());
  await eventually(pulsed);
  assert.match(JSON.stringify(await daemon.call("connection.list")), /hedgehog-racer/);
  // A warm ball can deliver less. On a busy machine a second of the daemon takes longer.
  const warmth = { direction: "up", current_a: 15, duration_ms: 2000, priority: 9, on_close: "finish" };
  const seconds = async () => (await daemon.call("ping")).time_ns * 1e-9;
  const end = await seconds() + 30;
  while (await meter() >= cool - 10) {
    const now = await seconds();
    assert.ok(now < end, `${await meter()} % of ${cool} %`);
    assert.ok((await daemon.call("effect.pulse", warmth)).accepted);
    await eventually(async () => await seconds() > now + 1);
  }
});

test("tilting the simulated ball steers and drives", async () => {
  await startDaemon();
  await startRacer({ daemon });
  await open();
  await until(() => window.racer.scene().mode === "ball");
  const turn = (degrees, x, y) => {
    const half = (degrees * Math.PI) / 360;
    return { w: Math.cos(half), x: x * Math.sin(half), y: y * Math.sin(half), z: 0 };
  };
  const tilt = (quaternion) => daemon.call("sim.set", { orientation: quaternion });
  await tilt(turn(25, 0, 1));
  await until(() => window.racer.scene().throttle > 0.5 && window.racer.scene().speed_mps > 2);
  await tilt(turn(25, -1, 0));
  await until(() => window.racer.scene().steer < -0.5 && window.racer.scene().throttle < 0.1);
  await page.keyboard.down("ArrowRight");
  await until(() => window.racer.scene().mode === "keyboard" && window.racer.scene().steer > 0.5);
});

test("the end and the silence of a game are reported, and the page reconnects", async () => {
  await startRacer({ more: ["--driver"] });
  await keepAddress();
  await open();
  pageErrors.expected = true;
  await racer.end("SIGKILL");
  await page.waitForSelector("body[data-link=gone]", kTimeout);
  assert.match(await page.textContent("#gone"), /The game is gone \(closed without a reason\)/);
  // On a busy machine a silence may follow at once, which replaces the text.
  await page.evaluate(() => {
    const gone = document.getElementById("gone");
    window.shown = [];
    new MutationObserver(() => window.shown.push(gone.textContent)).observe(gone, { childList: true, characterData: true, subtree: true });
  });
  await startRacer({ more: ["--driver"] });
  await until(() => window.shown.some((text) => /The game is back/.test(text)));
  await page.waitForSelector("body[data-link=open]", kTimeout);
  await racer.end("SIGTERM");
  assert.equal(racer.process.exitCode, 0);
  await until(() => /The game is gone \(it was stopped\)/.test(document.getElementById("gone").textContent));
  await startRacer({ more: ["--driver"] });
  await page.waitForSelector("body[data-link=open]", kTimeout);
  racer.process.kill("SIGSTOP");
  await page.waitForSelector("body[data-link=silent]", kTimeout);
  racer.process.kill("SIGCONT");
  await page.waitForSelector("body[data-link=open]", kTimeout);
});

test("a disconnected ball is reported, and the race continues", async () => {
  await startDaemon();
  await startRacer({ daemon, more: ["--driver"] });
  await open();
  await page.waitForSelector("body[data-ball=armed]", kTimeout);
  await daemon.call("device.emergency_stop");
  await until(() => /The ball is disarmed/.test(document.getElementById("help").textContent));
  await daemon.end();
  await page.waitForSelector("body[data-ball=none]", kTimeout);
  assert.match(await page.textContent("#strength"), /^No ball/);
  const before = (await page.evaluate(() => window.racer.scene().time_s));
  await until((then) => window.racer.scene().time_s > then + 0.5, before);
});

test("axe finds no serious fault, on a desk and on a phone, and thumbs can drive", async () => {
  await startRacer();
  for (const device of [kDesktop, kPhone]) {
    await page?.context().close();
    await open(device);
    assert.deepEqual(await seriousFaults(page), []);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${wide} px too wide`);
  }
  const box = await page.getByRole("button", { name: "throttle" }).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await until(() => window.racer.scene().throttle === 1);
  await page.mouse.up();
  await until(() => window.racer.scene().throttle === 0);
});

test("a page of another origin, and one under another name, are refused", async () => {
  await startRacer();
  const { port } = racer;
  await openBlank();
  const refused = (url) => page.evaluate((to) => new Promise((resolve) => {
    const socket = new WebSocket(to);
    socket.onopen = () => { socket.close(); resolve(false); };
    socket.onerror = () => resolve(true);
  }), url);
  await page.goto("about:blank");
  assert.equal(await refused(`ws://127.0.0.1:${port}/ws`), true);
  assert.equal(await refused(`ws://rebound.example:${port}/ws`), true);
  assert.equal((await page.goto(`http://rebound.example:${port}/`)).status(), 421);
});
