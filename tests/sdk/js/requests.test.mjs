// SPDX-License-Identifier: MIT
// Requests of a Ball on a virtual clock: parameters that JSON does not have, and how long connecting takes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { BallCore } from "../../../clients/js/src/ball.js";
import { NotConnected } from "../../../clients/js/src/errors.js";

const TIMEOUT_MS = 2000;
const HELLO = { limits: { current_a: 15, felt_a: 2.1 } };

/** Replaces the clock and the timers until the end of the test. */
class VirtualClock {
  nowMs = 1000;
  #timers = new Map();
  #last = 0;

  constructor(context) {
    const { setTimeout, clearTimeout } = globalThis;
    const now = performance.now;
    context.after(() => {
      Object.assign(globalThis, { setTimeout, clearTimeout });
      performance.now = now;
    });
    performance.now = () => this.nowMs;
    globalThis.setTimeout = (run, ms) => {
      this.#timers.set(++this.#last, { run, atMs: this.nowMs + ms });
      return this.#last;
    };
    globalThis.clearTimeout = (id) => this.#timers.delete(id);
  }

  /** Runs the timers that are due meanwhile. */
  advance(ms) {
    this.nowMs += ms;
    for (const [id, { run, atMs }] of this.#timers) {
      if (atMs > this.nowMs) continue;
      this.#timers.delete(id);
      run();
    }
  }

  /** Goes to the next timer, if there is one, once everything else has been done. */
  async next() {
    await new Promise((resolve) => setImmediate(resolve));
    const [first] = [...this.#timers.values()].map(({ atMs }) => atMs).sort((a, b) => a - b);
    if (first !== undefined) this.advance(first - this.nowMs);
  }
}

/** A connected ball whose daemon answers `hello` and `ping`; `sent`: the methods that it has received. */
async function connected(options) {
  const sent = [];
  const transport = async ({ message }) => ({
    send(text) {
      const { id, method } = JSON.parse(text);
      sent.push(method);
      queueMicrotask(() => message(JSON.stringify({ id, result: method === "hello" ? HELLO : {} })));
    },
    unsent: () => 0,
    close() {},
  });
  const ball = new BallCore(async () => [transport], { timeoutMs: TIMEOUT_MS, ...options });
  await ball.open();
  return { ball, sent };
}

const cycle = {};
cycle.itself = cycle;
const UNSENDABLE = [
  ["a BigInt", { start_at_ns: 1n }, /^effect\.pulse: start_at_ns: .*BigInt/],
  ["a cycle", { data: cycle }, /^effect\.pulse: data: .*circular/],
  ["NaN", { level: NaN }, /^effect\.pulse: level: NaN is not a finite number$/],
  ["an infinite number", { level: -Infinity }, /^effect\.pulse: level: -Infinity is not a finite number$/],
  ["NaN in a list", { direction: [0, NaN, 1] }, /^effect\.pulse: direction: NaN is not a finite number$/],
];

for (const [what, params, message] of UNSENDABLE) {
  test(`${what} as a parameter fails alone, and the connection goes on`, async (context) => {
    const clock = new VirtualClock(context);
    const { ball, sent } = await connected();
    await assert.rejects(ball.pulse("left", params), { name: "TypeError", message });
    assert.throws(() => ball.notify("effect.pulse", params), { name: "TypeError", message });
    clock.advance(TIMEOUT_MS);
    assert.ok(ball.connected);
    await ball.ping();
    assert.deepEqual(sent, ["hello", "ping"]);
  });
}

test("an introduction that JSON does not have ends its connection", async () => {
  const closed = [];
  const transport = async () => ({ send() {}, unsent: () => 0, close: () => closed.push(true) });
  const ball = new BallCore(async () => [transport], { name: 1n });
  await assert.rejects(ball.open(), { name: "TypeError", message: /^hello: client: .*BigInt/ });
  assert.ok(!ball.connected);
  assert.deepEqual(closed, [true]);
});

/** The time in which a ball fails to connect to these addresses, and which of them accepted it. */
async function failing(context, accepts) {
  const clock = new VirtualClock(context);
  const begin = clock.nowMs;
  const accepted = [];
  const connectors = accepts.map((accept, number) => async ({ timeoutMs }) => {
    if (!accept) {
      clock.advance(timeoutMs);
      throw new NotConnected("no answer");
    }
    accepted.push(number);
    return { send() {}, unsent: () => 0, close() {} };
  });
  const opened = new BallCore(async () => connectors, { timeoutMs: TIMEOUT_MS }).open();
  const failed = assert.rejects(opened, NotConnected);
  await clock.next();
  await failed;
  return { ms: clock.nowMs - begin, accepted };
}

for (const accepts of [[false, false, false], [false, false, true], [true, false]]) {
  test(`connecting takes ${TIMEOUT_MS} ms altogether: ${accepts.map((one) => (one ? "a daemon without a response" : "no answer"))}`, async (context) => {
    const { ms, accepted } = await failing(context, accepts);
    assert.ok(Math.abs(ms - TIMEOUT_MS) < 10, `${ms} ms`);
    assert.equal(accepted.length, accepts.includes(true) ? 1 : 0);
  });
}
