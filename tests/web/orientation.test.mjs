// SPDX-License-Identifier: MIT
// The orientation page in a browser, against a real daemon: up stays up, and the displayed state is correct.
import assert from "node:assert/strict";
import { test } from "node:test";

import { kDesktop, kPhone } from "./browser.mjs";
import { daemon, open, page, startDaemon, until } from "./dashboard.mjs";
import { eventually } from "./timeouts.mjs";

test("the orientation page keeps the push on top while the ball turns", async () => {
  await open("/orientation.html");
  await page.getByText("Steady, 5 A").click();
  await page.getByRole("button", { name: "Show up" }).click();
  await until(() => (window.dashboard.ball.arrowDirection()?.[2] ?? 0) > 0.98);
  for (let i = 0; i < 12; ++i) await page.keyboard.press("ArrowDown");
  await until(() => {
    const { ball } = window.dashboard;
    const arrow = ball.arrow.visible && ball.arrow.getWorldDirection(ball.camera.position.clone());
    return arrow && arrow.z > 0.98 && Math.abs(ball.arrowDirection()[2]) < 0.2;
  });
  await page.getByRole("button", { name: "Stop showing" }).click();
  await until(() => window.dashboard.ball.arrowDirection() === null);
});

const showUp = async () => {
  await page.getByText("Steady, 5 A").click();
  await page.getByRole("button", { name: "Show up" }).click();
  await until(() => (window.dashboard.ball.arrowDirection()?.[2] ?? 0) > 0.98);
};
/** Polls the daemon, which has no event for this. */
const shows = () => daemon.call("device.status").then(({ effects }) => effects.some(({ slot }) => slot === "up"));

test("a push that a stop or a trip ends is shown as ended with its reason", async () => {
  await open("/orientation.html");
  await showUp();
  await daemon.call("device.emergency_stop");
  await until(() => document.getElementById("indicate").getAttribute("aria-pressed") === "false");
  assert.match(await page.textContent("#said"), /^The coils are off; up is no longer shown/);
  await daemon.call("device.arm");
  await showUp();
  await daemon.call("sim.set", { fault: { faults: ["sensor_open"] } });
  await until(() => document.getElementById("indicate").textContent === "Show up");
  assert.match(await page.textContent("#said"), /^The coils are off; up is no longer shown/);
});

test("a page that was suspended for longer than its lease shows up again", async () => {
  await open("/orientation.html");
  await showUp();
  await page.evaluate(() => {
    const { link } = window.dashboard;
    link.notifyBefore = link.notify;
    link.notify = () => {};
  });
  await eventually(async () => await daemon.ended("expired") > 0);
  await page.evaluate(() => { window.dashboard.link.notify = window.dashboard.link.notifyBefore; });
  await eventually(shows);
  await until(() => (window.dashboard.ball.arrowDirection()?.[2] ?? 0) > 0.98);
  assert.equal(await page.getAttribute("#indicate", "aria-pressed"), "true");
});

test("a push that ended for lack of orientation resumes with it", async () => {
  await daemon.end();
  await startDaemon({ config: { imu: { type: "external" } } });
  await open("/orientation.html");
  const feed = () => page.evaluate(() => {
    const { link } = window.dashboard;
    window.feed = setInterval(() => link.notify("orientation.set", { quaternion: { w: 1, x: 0, y: 0, z: 0 } }), 20);
  });
  await feed();
  await eventually(() => daemon.call("device.status").then(({ orientation }) => orientation));
  await showUp();
  // The lease must not expire first.
  await page.evaluate(() => window.dashboard.link.call("effect.update", { slot: "up", lease_ms: 10_000 }));
  await page.evaluate(() => clearInterval(window.feed));
  await eventually(async () => await daemon.ended("orientation_lost") > 0);
  await until(() => window.dashboard.ball.arrowDirection() === null);
  await feed();
  await until(() => (window.dashboard.ball.arrowDirection()?.[2] ?? 0) > 0.98);
  assert.equal(await page.textContent("#indicate"), "Stop showing");
});

test("a phone's angles are the ball's: top to the front, screen up", async () => {
  await open("/orientation.html");
  const turned = (angles) => page.evaluate((a) => window.dashboard.quaternionOf(...a).toArray(), angles);
  const near = (q, expected) => assert.ok(Math.abs(q.reduce((sum, v, i) => sum + v * expected[i], 0)) > 0.9999, q.join());
  const half = Math.SQRT1_2;
  // Flat, its top towards the world's y: the ball's front (x) points along y.
  near(await turned([0, 0, 0]), [0, 0, half, half]);
  near(await turned([-90, 0, 0]), [0, 0, 0, 1]);
  // Upright (beta 90): the front points up.
  near(await turned([-90, 90, 0]), [0, -half, 0, half]);
});

/** The button, and the orientation events of a phone that is tilted by `beta`. */
const tiltPhone = async (beta) => {
  await page.getByRole("button", { name: "Turn it with this phone" }).click();
  await page.evaluate((angle) => setInterval(() => dispatchEvent(
    new DeviceOrientationEvent("deviceorientation", { alpha: 30, beta: angle, gamma: 0 })), 50), beta);
};
const turnedBy = () => page.evaluate(() => 2 * Math.acos(Math.min(1, Math.abs(window.dashboard.ball.body.quaternion.w))));

test("a phone whose orientation the daemon accepts turns the ball", async () => {
  await open("/orientation.html");
  await tiltPhone(50);
  await until(() => document.getElementById("sensor").textContent === "The phone turns the ball.");
  await eventually(async () => Math.abs((await daemon.call("device.status")).orientation.up[2]) < 0.8);
});

test("a phone whose orientation the daemon refuses shows the reason, and the ball is drawn as it is", async () => {
  // The page receives "simulated": false; the daemon's ball is simulated, so it rejects the request.
  await open("/orientation.html", kDesktop, (fresh) => fresh.routeWebSocket("**/ws", (socket) => {
    const server = socket.connectToServer();
    server.onMessage((text) => socket.send(text.replace('"simulated":true', '"simulated":false')));
  }));
  await tiltPhone(50);
  await until(() => /^The sensor is simulated/.test(document.getElementById("sensor").textContent));
  assert.ok(await turnedBy() < 0.1);
  await daemon.call("sim.set", { orientation: { w: 0, x: 1, y: 0, z: 0 } });
  await eventually(async () => await turnedBy() > 3);
});

test("both arrows are in the picture to their tips, whichever way the ball is turned", async () => {
  for (const [path, device] of [["/orientation.html", kDesktop], ["/orientation.html", kPhone], ["/", kPhone], ["/", { viewport: { width: 1000, height: 800 } }]]) {
    await page?.context().close();
    await open(path, device);
    const outside = await page.evaluate(() => {
      const { ball } = window.dashboard;
      const found = [];
      const frameArrow = (arrow, name) => {
        const { tip, tipLength } = arrow.userData;
        ball.scene.updateMatrixWorld(true);
        const end = tip.localToWorld(ball.camera.position.clone().set(0, tipLength / 2, 0)).project(ball.camera);
        if (Math.max(Math.abs(end.x), Math.abs(end.y)) > 1) found.push(`${name}: ${end.x.toFixed(2)}, ${end.y.toFixed(2)}`);
      };
      ball.showUp();
      frameArrow(ball.up, "up");
      for (let azimuth = 0; azimuth < 360; azimuth += 15) {
        for (const height of [-0.8, -0.3, 0, 0.3, 0.8]) {
          const flat = Math.sqrt(1 - height * height);
          ball.setField([flat * Math.cos((azimuth * Math.PI) / 180), flat * Math.sin((azimuth * Math.PI) / 180), height], 1);
          frameArrow(ball.arrow, `azimuth ${azimuth}, height ${height}`);
        }
      }
      return found;
    });
    assert.deepEqual(outside, [], `${path} at ${device.viewport.width} px`);
  }
});
