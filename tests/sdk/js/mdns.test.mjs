// SPDX-License-Identifier: MIT
// Runs mdns.json on the JavaScript library, and searches on the loopback interface.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { daemonAddresses, describe } from "../../../clients/js/src/addresses.js";
import { chosen } from "../../../clients/js/src/discovery.js";
import { Answers, SERVICE } from "../../../clients/js/src/mdns.js";
import { AddressError, Ball, NotConnected, discover } from "../../../clients/js/src/node.js";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const vectors = JSON.parse(fs.readFileSync(here("../mdns.json"), "utf8"));
const fingerprint = "a".repeat(64);
const responders = [];

after(async () => {
  for (const { process, ended } of responders) {
    process.stdin.end();
    await ended;
  }
});

/** Announces balls, each as: name, serial number, address, port. */
async function announce(...balls) {
  const process_ = spawn("python3", [here("../mdns_responder.py"), ...balls.flat().map(String)], { stdio: ["pipe", "pipe", "inherit"] });
  responders.push({ process: process_, ended: new Promise((resolve) => process_.on("close", resolve)) });
  process.env.HEDGEHOG_MDNS_PORT = String(await new Promise((resolve) => process_.stdout.once("data", resolve))).trim();
}

test("searches", () => {
  for (const { name, packets, balls, query } of vectors.searches) {
    const answers = new Answers(vectors.id);
    for (const packet of packets) answers.read(Buffer.from(packet, "hex"));
    assert.deepEqual(answers.balls(), balls, name);
    if (query) assert.equal(answers.query().toString("hex"), query, name);
  }
});

test("every cut and every flipped byte ends", () => {
  for (const packet of vectors.searches.slice(0, 3).flatMap(({ packets }) => packets.map((hex) => Buffer.from(hex, "hex")))) {
    for (let at = 0; at < packet.length; ++at) {
      const answers = new Answers(vectors.id);
      answers.read(packet.subarray(0, at));
      assert.deepEqual(answers.balls(), []);
      const flipped = Buffer.from(packet);
      flipped[at] ^= 0xff;
      answers.read(flipped);
      answers.balls();
      answers.query();
    }
  }
});

test("a flood is bounded", () => {
  const answers = new Answers(vectors.id);
  for (let i = 0; i < 2000; ++i) {
    const instance = Buffer.from(`\x04${String(i).padStart(4, "0")}${SERVICE}`, "latin1");
    const size = Buffer.from([0, instance.length]);
    const numbers = Buffer.from("000c00010000000a", "hex");
    answers.read(Buffer.concat([Buffer.from("123484000000000100000000", "hex"), Buffer.from(SERVICE, "latin1"), numbers, size, instance]));
  }
  assert.ok(answers.query().length <= 1200);
  // All on one host, so that all addresses are known; at most 256 balls are kept.
  const host = Buffer.from("\x01h\0", "latin1");
  for (let i = 0; i < 2000; ++i) {
    const instance = Buffer.from(`\x04${String(i).padStart(4, "0")}${SERVICE}`, "latin1");
    const header = Buffer.from("123484000000000200000000", "hex");
    const service = Buffer.concat([instance, Buffer.from("002100010000000a0009000000000001", "hex"), host]);
    answers.read(Buffer.concat([header, service, host, Buffer.from("000100010000000a00047f000001", "hex")]));
  }
  assert.equal(answers.balls().length, 256);
});

test("choices", () => {
  for (const { name, asked, balls, addresses, error } of vectors.choices) {
    if (error) {
      assert.throws(() => chosen(asked, balls), (thrown) => thrown instanceof NotConnected && thrown.message === error, name);
    } else {
      assert.deepEqual(chosen(asked, balls).map(({ address, port }) => describe({ host: address, port, tls: true })), addresses, name);
    }
  }
});

test("addresses", () => {
  for (const { text, fingerprint: pinned, means, error } of vectors.addresses) {
    const read = () => daemonAddresses(undefined, { HEDGEHOG_ADDRESS: text, HEDGEHOG_FINGERPRINT: pinned });
    if (error) assert.throws(read, (thrown) => thrown instanceof AddressError && thrown.message === error);
    else assert.equal(describe(read()[0]), means);
  }
});

test("all balls are listed", async () => {
  await announce(["ball-7", "0007", "127.0.0.1", 17586], ["ball-9", "0009", "127.0.0.1", 17587]);
  const common = { host: "lab.local", address: "127.0.0.1", protocol: "1.0", tls: true };
  assert.deepEqual(await discover(2000), [
    { name: "ball-7", port: 17586, serial: "0007", ...common },
    { name: "ball-9", port: 17587, serial: "0009", ...common },
  ]);
});

test("a search without an answer is an error, and is not repeated at once", async () => {
  await announce();
  const ball = new Ball({ address: "mdns://", fingerprint });
  await assert.rejects(ball.open(), (error) => {
    assert.ok(error instanceof NotConnected && error.retryAfterMs > 0, error);
    assert.equal(error.message, "no ball answers on this network (mDNS, 1 s)");
    return true;
  });
  ball.close();
});

test("the selected ball is connected to", async () => {
  // No listener on these ports: the error contains the chosen address.
  await announce(["ball-7", "0007", "127.0.0.1", 9], ["ball-9", "0009", "127.0.0.1", 10]);
  const refused = (address, message) => assert.rejects(Ball.connect({ address, fingerprint }), { name: "NotConnected", message });
  await refused("mdns://0009", "the daemon does not run: tls://127.0.0.1:10: Connection refused");
  await refused("mdns://", /^several balls .*"ball-7".*"ball-9"/);
});
