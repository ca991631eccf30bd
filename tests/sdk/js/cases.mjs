// SPDX-License-Identifier: MIT
// Tests of one library by conformance.json.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const { cases } = JSON.parse(fs.readFileSync(here("../conformance.json"), "utf8"));
const TIMEOUT_S = 60;

async function fakeDaemon(name, more) {
  const process = spawn("python3", [here("../fake_daemon.py"), name, ...more], { stdio: ["ignore", "pipe", "pipe"] });
  let errors = "";
  process.stderr.on("data", (text) => (errors += text));
  const ended = new Promise((resolve) => process.on("close", (code) => resolve([code, errors])));
  const port = await new Promise((resolve) => process.stdout.once("data", resolve));
  return { port: String(port).trim(), ended };
}

/** Checks the outcome of a step. */
function check(step, outcome) {
  if (step.failure) {
    assert.equal(outcome.failure, step.failure, JSON.stringify(outcome));
    assert.ok(outcome.message.includes(step.says), outcome.message);
    if (step.retry_s) assert.ok(outcome.retryS >= step.retry_s[0] && outcome.retryS <= step.retry_s[1], `${outcome.retryS} s`);
  } else if (step.error) {
    assert.deepEqual(outcome, { error: step.error });
  } else {
    assert.ok("value" in outcome, JSON.stringify(outcome));
    if (step.result) assert.deepEqual(outcome.value, step.result);
    else if (step.next_of) assert.deepEqual(outcome.value, step.params);
    else if (step.not_finite || step.notify || step.rumble || step.rumble_again || step.flood) assert.equal(outcome.value, true);
    else if ("reconnected" in step) assert.equal(outcome.value, step.reconnected);
    else if (step.subscriptions_ended) assert.deepEqual(outcome.value, step.subscriptions_ended);
    else if (step.notification) assert.deepEqual(outcome.value, [step.notification, step.params ?? {}]);
  }
}

/** Writes a line for the table of run.sh. */
function report(library, name, outcome) {
  const table = process.env.HEDGEHOG_CONFORMANCE_TABLE;
  if (table) fs.appendFileSync(table, `${library}\t${name}\t${outcome}\n`);
}

/**
 * Adds a test for each case. `driver`: creates a Driver, or an object that forwards its steps to one. `address`: returns the
 * address of a daemon for a port. `more`: arguments of fake_daemon.py.
 */
export function addCases(library, driver, address, more = []) {
  for (const one of cases.filter(({ without = [] }) => !without.includes(library))) {
    test(`${library}: ${one.name}`, async (context) => {
      let passed = false;
      context.after(() => report(library, one.name, passed ? "ok" : "failed"));
      const daemon = await fakeDaemon(one.name, more);
      const before = { ...process.env };
      Object.assign(process.env, one.environment);
      context.after(() => (process.env = before));
      const ball = await driver();
      const opened = await ball.open({
        address: address(daemon.port),
        name: "conformance",
        timeoutMs: 1000 * (one.timeout_s ?? TIMEOUT_S),
      });
      const [first, ...rest] = one.client[0].open ? one.client : [{ open: true }, ...one.client];
      check(first, opened);
      for (const step of rest) {
        const began = performance.now();
        check(step, await ball.do(step));
        const s = (performance.now() - began) / 1000;
        assert.ok(s >= (step.at_least_s ?? 0), `${s} s`);
      }
      await ball.close();
      assert.deepEqual(await daemon.ended, [0, ""]);
      passed = true;
    });
  }
}
