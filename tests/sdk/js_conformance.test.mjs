// SPDX-License-Identifier: MIT
// conformance.json against the JavaScript library in Node.js.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import fs from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { Ball, NotConnected, RequestError } from "../../clients/js/src/node.js";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const { cases } = JSON.parse(fs.readFileSync(here("conformance.json"), "utf8"));
const PATIENCE_MS = 60_000;
// A case in which the daemon never answers takes as long as the library's patience.
const SLOW = "a slow response ends the connection, the next call makes a new one";

async function fakeDaemon(name) {
  const process = spawn("python3", [here("fake_daemon.py"), name], { stdio: ["ignore", "pipe", "pipe"] });
  let errors = "";
  process.stderr.on("data", (text) => (errors += text));
  const ended = new Promise((resolve) => process.on("close", (code) => resolve([code, errors])));
  const port = await new Promise((resolve) => process.stdout.once("data", resolve));
  return { address: `127.0.0.1:${String(port).trim()}`, ended };
}

/** The promise has to end as the step says. */
async function outcome(step, promise) {
  if (step.failure) {
    await assert.rejects(promise, (error) => error instanceof NotConnected && error.message.includes(step.says));
    return undefined;
  }
  if (step.error) {
    await assert.rejects(promise, (error) => {
      assert.ok(error instanceof RequestError);
      assert.deepEqual([error.code, error.reason, error.message], [step.error.code, step.error.name, step.error.message]);
      assert.equal(error.data.field, step.error.field);
      return true;
    });
    return undefined;
  }
  return promise;
}

async function again(ball, method) {
  for (;;) {
    try {
      return await ball.call(method);
    } catch (error) {
      if (!(error instanceof NotConnected)) throw error;
      await new Promise((resolve) => setTimeout(resolve, error.retryAfterMs));
    }
  }
}

async function play(ball, notifications, step) {
  if (step.call) {
    const result = await outcome(step, ball.call(step.call, step.params));
    if (step.result) assert.deepEqual(result, step.result);
  } else if (step.call_again) {
    assert.deepEqual(await again(ball, step.call_again), step.result);
  } else if (step.notify) {
    assert.ok(ball.notify(step.notify, step.params));
  } else if (step.rumble) {
    assert.ok(ball.rumble(step.rumble, step.strength, step.direction, step.params));
  } else {
    const { value } = await notifications.next();
    assert.deepEqual(value, [step.notification, step.params]);
  }
}

/** For the table of run.sh. */
function report(name, outcome) {
  const table = process.env.HEDGEHOG_CONFORMANCE_TABLE;
  if (table) fs.appendFileSync(table, `JavaScript\t${name}\t${outcome}\n`);
}

for (const one of cases) {
  test(one.name, async (context) => {
    let passed = false;
    context.after(() => report(one.name, passed ? "ok" : "failed"));
    const daemon = await fakeDaemon(one.name);
    const options = { address: daemon.address, name: "conformance", patienceMs: one.name === SLOW ? 3000 : PATIENCE_MS };
    if (one.client[0].open) {
      await outcome(one.client[0], Ball.connect(options));
    } else {
      const ball = await Ball.connect(options);
      const notifications = ball.notifications();
      for (const step of one.client) await play(ball, notifications, step);
      ball.close();
    }
    assert.deepEqual(await daemon.ended, [0, ""]);
    passed = true;
  });
}
