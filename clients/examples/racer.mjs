#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// What is felt in a racing game: a lap of three seconds with two gear changes, a skid, a hit, a crate and a landing.
// Exit: 0 it was played, 69 there is no daemon, or it has gone.
import { Ball, NotConnected } from "@hedgehog/client";

// Eight steps from what is just felt to full strength are 32 % apart; people notice 13 % (thesis, experiment 2).
const STEPS = 8;
// Blows of these impulses are the first and the last step; Newton seconds.
const SOFTEST_BLOW = 150;
const HARDEST_BLOW = 8000;
// One blow in 0.25 s, unless a harder one comes.
const APART_S = 0.25;
// Of two effects only the one of higher priority is felt; of the same, both.
const PRIORITY = { engine: 3, gear: 4, skid: 5, impact: 7 };
const FRAMES = 180;
const RATE_HZ = 60;

const HAPPENINGS = new Map([
  [100, ["wall", [0.7, -0.7, 0], 5000]],
  [105, ["crate", "left", 300]],
  [150, ["landing", "down", 2500]],
]);

function stepOf(impulseNs) {
  const share = Math.log(Math.max(impulseNs, SOFTEST_BLOW) / SOFTEST_BLOW) / Math.log(HARDEST_BLOW / SOFTEST_BLOW);
  return Math.round((STEPS - 1) * Math.min(share, 1));
}

/** Nothing here waits for a response. */
class CarFeel {
  #ball;
  #lastStep = -1;
  #lastS = -APART_S;

  constructor(ball) {
    this.#ball = ball;
  }

  /** Every frame, 0..1 each. False: there is no daemon. */
  engine(revolutions, throttle) {
    const more = { frequency_hz: 30 + 60 * revolutions, priority: PRIORITY.engine };
    return this.#ball.rumble("engine", 0.05 + 0.25 * throttle, "back", more);
  }

  /** Every frame while the wheels slide; 0 they grip .. 1 not at all. It lasts, so it is weaker than a blow can be. */
  skid(amount) {
    this.#ball.rumble("skid", 0.5 * amount, "down", { waveform: "square", frequency_hz: 60, priority: PRIORITY.skid });
  }

  /** The clutch has closed: a knock from behind. */
  gear() {
    this.#pulse("back", 1, 40, PRIORITY.gear);
  }

  /** The car was hit on that side, or landed; its step, or -1 when it is too soon to be felt. */
  impact(side, impulseNs, timeS) {
    const step = stepOf(impulseNs);
    if (timeS - this.#lastS < APART_S && step <= this.#lastStep) return -1;
    this.#lastStep = step;
    this.#lastS = timeS;
    this.#pulse(side, step, 180, PRIORITY.impact);
    return step;
  }

  #pulse(direction, step, duration_ms, priority) {
    if (!this.#ball.hello) return;
    const { felt_a, current_a } = this.#ball.hello.limits;
    const strength = felt_a * (current_a / felt_a) ** (step / (STEPS - 1));
    this.#ball.notify("effect.pulse", { direction, current_a: strength, duration_ms, priority });
  }
}

function playFrame(feel, frame) {
  const timeS = frame / RATE_HZ;
  if (frame === 30 || frame === 60) {
    feel.gear();
    console.log(`${timeS.toFixed(2)} s  gear`);
  }
  if (frame > 60 && frame < 90) feel.skid((frame - 60) / 30);
  const [what, side, impulseNs] = HAPPENINGS.get(frame) ?? [];
  if (what) console.log(`${timeS.toFixed(2)} s  ${what}: step ${feel.impact(side, impulseNs, timeS)}`);
  return feel.engine((frame % 60) / 60, 1);
}

try {
  const ball = await Ball.connect({ name: "racer example" });
  const feel = new CarFeel(ball);
  for (let frame = 0; frame < FRAMES; ++frame) {
    if (!playFrame(feel, frame)) throw new NotConnected("the daemon has gone");
    await new Promise((resolve) => setTimeout(resolve, 1000 / RATE_HZ));
  }
  await ball.stopAll();
  ball.close();
} catch (error) {
  if (!(error instanceof NotConnected)) throw error;
  console.error(error.message);
  process.exitCode = 69;
}
