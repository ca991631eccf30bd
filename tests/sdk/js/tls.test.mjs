// SPDX-License-Identifier: MIT
// The JavaScript library with a remote daemon: TLS, fingerprint and token.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import crypto from "node:crypto";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { parseFingerprint } from "../../../clients/js/src/addresses.js";
import { AddressError, Ball, NotConnected, RequestError } from "../../../clients/js/src/node.js";

const token = "hht_of-a-test";
const timeoutMs = 60_000;
let folder;
let daemon;
let address;
let fingerprint;

before(async () => {
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "hedgehog-js-"));
  const state = path.join(folder, "hedgehog");
  fs.mkdirSync(state);
  const certificate = path.join(state, "certificate.pem");
  execFileSync(
    "openssl",
    ["req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "30", "-subj"].concat(
      ["/CN=ball-host", "-keyout", path.join(state, "key.pem"), "-out", certificate]),
    { stdio: "ignore" },
  );
  fingerprint = new crypto.X509Certificate(fs.readFileSync(certificate)).fingerprint256;
  const digest = crypto.createHash("sha256").update(token).digest("hex");
  fs.writeFileSync(path.join(state, "tokens"), `arcade play sha256:${digest} 2026-11-24\n`);
  daemon = spawn(process.env.HEDGEHOGD, ["--simulate", "--speed", "1", "--listen", "tls://127.0.0.1:0"], {
    env: { ...process.env, HOME: folder, XDG_CONFIG_HOME: folder, XDG_STATE_HOME: folder, XDG_RUNTIME_DIR: folder },
    stdio: ["ignore", "pipe", "ignore"],
  });
  for await (const line of createInterface({ input: daemon.stdout })) {
    address = /^listening on (tls:\/\/127\.0\.0\.1:\d+)$/.exec(line)?.[1];
    if (address) break;
  }
});

after(async () => {
  const ended = new Promise((resolve) => daemon.on("close", resolve));
  daemon.kill();
  await ended;
  fs.rmSync(folder, { recursive: true });
});

test("the token gives its role", async () => {
  const ball = await Ball.connect({ address, token, fingerprint, timeoutMs });
  assert.equal(ball.hello.role, "play");
  const events = ball.events(["effect_ended"]);
  const first = events.next();
  const { effect } = await ball.pulse("left", { level: 0.5, duration_ms: 30 });
  assert.equal((await first).value.effect, effect);
  await events.return();
  ball.close();
});

test("the fingerprint may be written as hedgehogctl prints it", async () => {
  const plain = fingerprint.replaceAll(":", "").toLowerCase();
  assert.equal(parseFingerprint(plain), fingerprint);
  const ball = await Ball.connect({ address, token, fingerprint: plain, timeoutMs });
  ball.close();
  assert.throws(() => new Ball({ address, fingerprint: "0" }), AddressError);
});

test("another fingerprint, or an unverified certificate, is rejected", async () => {
  const refused = (options, pattern) =>
    assert.rejects(Ball.connect({ address, token, timeoutMs, ...options }), (error) => {
      assert.ok(error instanceof NotConnected, error);
      assert.match(error.message, pattern);
      return true;
    });
  await refused({ fingerprint: "0".repeat(64) }, /another fingerprint/);
  await refused({}, /self-signed/);
});

test("an announced daemon is verified by its fingerprint too", async () => {
  const { port } = new URL(address.replace("tls:", "http:"));
  const responder = spawn("python3", [fileURLToPath(new URL("../mdns_responder.py", import.meta.url)), "ball-7", "0007", "127.0.0.1", port], {
    stdio: ["pipe", "pipe", "inherit"],
  });
  const ended = new Promise((resolve) => responder.on("close", resolve));
  try {
    process.env.HEDGEHOG_MDNS_PORT = String(await new Promise((resolve) => responder.stdout.once("data", resolve))).trim();
    const announced = { address: "mdns://ball-7", token, timeoutMs };
    const ball = await Ball.connect({ ...announced, fingerprint });
    assert.equal(ball.hello.role, "play");
    ball.close();
    await assert.rejects(Ball.connect({ ...announced, fingerprint: "0".repeat(64) }), /another fingerprint/);
  } finally {
    responder.stdin.end();
    await ended;
    delete process.env.HEDGEHOG_MDNS_PORT;
  }
});

test("a wrong token is refused", async () => {
  await assert.rejects(Ball.connect({ address, token: "hht_wrong", fingerprint, timeoutMs }), RequestError);
});
