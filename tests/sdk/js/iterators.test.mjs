// SPDX-License-Identifier: MIT
// The iterators of a Ball that is closed, or that nobody reads any more: none waits for ever.
import assert from "node:assert/strict";
import { test } from "node:test";
import { NotConnected } from "../../../clients/js/src/errors.js";
import { BallCore } from "../../../clients/js/src/ball.js";

const HELLO = { limits: { current_a: 15, felt_a: 2.1 } };
const DONE = { value: undefined, done: true };
const closed = { name: "NotConnected", message: /this ball is closed/ };

/** A connected ball whose daemon answers every request; `send`: a message of the daemon. */
async function connected() {
  let receive;
  const transport = async ({ message }) => {
    receive = message;
    return {
      send(text) {
        const { id, method } = JSON.parse(text);
        queueMicrotask(() => message(JSON.stringify({ id, result: method === "hello" ? HELLO : {} })));
      },
      unsent: () => 0,
      close() {},
    };
  };
  const ball = new BallCore(async () => [transport]);
  await ball.open();
  return { ball, send: (method, params) => receive(JSON.stringify({ method, params })) };
}

/** The outcome, or "waits" when it is not settled although nothing else is to be done. */
function settled(promise) {
  return Promise.race([promise, new Promise((resolve) => setImmediate(resolve, "waits"))]);
}

for (const kind of ["events", "telemetry", "notifications"]) {
  test(`${kind}() of a closed ball fails`, async () => {
    const { ball } = await connected();
    ball.close();
    const iterator = ball[kind]();
    await assert.rejects(settled(iterator.next()), closed);
    assert.deepEqual(await settled(iterator.next()), DONE);
  });

  test(`${kind}(): what waits when the ball is closed fails once, and the iterator has ended`, async () => {
    const { ball } = await connected();
    const iterator = ball[kind]();
    const waiting = iterator.next();
    await new Promise(setImmediate);
    ball.close();
    await assert.rejects(settled(waiting), NotConnected);
    assert.deepEqual(await settled(iterator.next()), DONE);
  });

  test(`${kind}(): return() ends what waits`, async () => {
    const { ball } = await connected();
    const iterator = ball[kind]();
    const waiting = [iterator.next(), iterator.next()];
    await new Promise(setImmediate);
    assert.deepEqual(await settled(iterator.return()), DONE);
    for (const one of waiting) assert.deepEqual(await settled(one), DONE);
    assert.deepEqual(await settled(iterator.next()), DONE);
    ball.close();
  });

  test(`${kind}(): each of several that wait gets a message of its own`, async () => {
    const { ball, send } = await connected();
    const iterator = ball[kind]();
    const waiting = [iterator.next(), iterator.next()];
    await new Promise(setImmediate);
    for (const number of [1, 2]) send(kind === "telemetry" ? kind : "event", { number });
    const values = (await settled(Promise.all(waiting))).map(({ value }) => (kind === "notifications" ? value[1] : value).number);
    assert.deepEqual(values, [1, 2]);
    ball.close();
  });
}
