// SPDX-License-Identifier: MIT
// The JavaScript library and its README with a simulated daemon; HEDGEHOGD: its program.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { daemonAddresses, parseAddress } from "../../../clients/js/src/addresses.js";
import { AddressError, Ball, NotConnected } from "../../../clients/js/src/node.js";
import { example, installed } from "./installed.mjs";

const library = fileURLToPath(new URL("../../../clients/js", import.meta.url));
let folder;
let daemon;
let address;

before(async () => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "hedgehog-js-"));
  daemon = spawn(process.env.HEDGEHOGD, ["--simulate", "--speed", "1", "--listen", "127.0.0.1:0"], {
    env: { ...process.env, HOME: folder, XDG_CONFIG_HOME: folder, XDG_STATE_HOME: folder, XDG_RUNTIME_DIR: folder },
    stdio: ["ignore", "pipe", "ignore"],
  });
  for await (const line of createInterface({ input: daemon.stdout })) {
    address = /^listening on (127\.0\.0\.1:\d+)$/.exec(line)?.[1];
    if (address) break;
  }
});

after(async () => {
  const ended = new Promise((resolve) => daemon.on("close", resolve));
  daemon.kill();
  await ended;
  fs.rmSync(folder, { recursive: true });
});

test("the first example of the README runs in an empty folder that has the packed library", () => {
  const game = installed();
  const text = example("js");
  assert.ok(text.trim().split("\n").length <= 10);
  fs.writeFileSync(path.join(game.folder, "game.mjs"), text);
  const printed = execFileSync(process.execPath, ["game.mjs"], {
    cwd: game.folder,
    env: { ...process.env, HEDGEHOG_ADDRESS: address },
    encoding: "utf8",
  });
  assert.ok(Number(printed) > 10);
  game.remove();
});

test("the pages in the package link only to what is in it", () => {
  const game = installed();
  const packed = path.join(game.folder, "node_modules", "@hedgehog", "client");
  const pages = fs.readdirSync(packed).filter((name) => name.endsWith(".md"));
  assert.deepEqual(pages.sort(), ["README.md", "connection.md"]);
  let links = 0;
  for (const page of pages) {
    for (const [, target] of fs.readFileSync(path.join(packed, page), "utf8").matchAll(/\]\(([^):#]+)(?:#[^)]*)?\)/g)) {
      assert.ok(fs.existsSync(path.join(packed, target)), `${page}: the link to ${target} leads nowhere`);
      ++links;
    }
  }
  assert.ok(links > 0);
  game.remove();
});

test("a pulse is played and ends", async () => {
  const ball = await Ball.connect({ address, timeoutMs: 60_000 });
  const events = ball.events(["effect_ended"]);
  const first = events.next();
  const { effect } = await ball.pulse("left", { level: 0.5, duration_ms: 30 });
  const { value } = await first;
  assert.deepEqual([value.effect, value.reason], [effect, "completed"]);
  await events.return();
  ball.close();
});

test("a rumble continues in its slot", async () => {
  const ball = await Ball.connect({ address, timeoutMs: 60_000 });
  const events = ball.events(["effect_started"]);
  const first = events.next();
  await ball.ping();
  assert.ok(ball.rumble("engine", 0.3, "back", { lease_ms: 10_000 }));
  assert.equal((await first).value.slot, "engine");
  // The README's circle may still be playing, without a slot.
  assert.deepEqual((await ball.status()).effects.map((one) => one.slot).filter((slot) => slot), ["engine"]);
  assert.ok(ball.rumble("engine", 0));
  assert.equal((await ball.stopAll()).stopped, 0);
  ball.close();
});

test("a missing daemon is reported in a sentence", async () => {
  await assert.rejects(Ball.connect({ address: "127.0.0.1:1" }), (error) => {
    assert.ok(error instanceof NotConnected);
    assert.match(error.message, /the daemon does not run: 127\.0\.0\.1:1: Connection refused/);
    return true;
  });
});

test("methods are those of the OpenRPC document", () => {
  execFileSync(process.execPath, [`${library}/generate.mjs`, "--check"]);
});

test("addresses are those of every client", () => {
  assert.deepEqual(daemonAddresses(undefined, { HEDGEHOG_ADDRESS: "[::1]:9" }, 7), [{ host: "::1", port: 9 }]);
  assert.deepEqual(daemonAddresses(undefined, {}, 7), [
    { path: "/run/hedgehog/hedgehogd.sock" },
    { path: "/tmp/hedgehog-7/hedgehogd.sock" },
    { host: "127.0.0.1", port: 7586 },
  ]);
  assert.deepEqual(daemonAddresses(undefined, { RUNTIME_DIRECTORY: "/a:/b", XDG_RUNTIME_DIR: "/u" }, 7), [
    { path: "/a/hedgehogd.sock" },
    { path: "/run/hedgehog/hedgehogd.sock" },
    { path: "/u/hedgehog/hedgehogd.sock" },
    { host: "127.0.0.1", port: 7586 },
  ]);
  assert.deepEqual(parseAddress("::1"), { host: "::1", port: 7586 });
  for (const text of ["host:x", "host:0", "[::1", "unix:", ":7", "host:70000", "host:"])
    assert.throws(() => parseAddress(text), AddressError, text);
});
