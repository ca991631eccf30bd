// SPDX-License-Identifier: MIT
// Gains of the board's readings, as bench instruments measure them: against the true current and voltage of the simulated ball.
import { eventually, passed } from './daemon.mjs';

const kReadings = 40;
/** Before the readings, and again after them: at one moment the supply's ripple is up to 2 % of it. */
const kTruths = 12;
/** Not a divisor of the supply's ripple (100 Hz). */
const kRateHz = 30;
const kCurrentA = 3;
const kSettlingMs = 500;
const kLeaseMs = 10_000;
/** Directions of positive and negative current in each winding, for a ball with the identity as its coil matrix. */
const kSides = [['front', 'back'], ['left', 'right'], ['up', 'down']];

const mean = (values) => values.reduce((sum, one) => sum + one, 0) / values.length;

/** Mean of `read(status)` over the next telemetry. */
async function meanReading(ball, fields, read) {
  const values = [];
  for await (const status of ball.telemetry(kRateHz, fields)) {
    values.push(read(status));
    if (values.length === kReadings) break;
  }
  await ball.call('telemetry.unsubscribe');
  return mean(values);
}

/** Read and true current of winding `k` while kCurrentA flow towards `side`, which is `sign` of it, A. */
async function currents(ball, side, k, sign) {
  await ball.hold(side, { slot: 'gauges', current_a: kCurrentA, lease_ms: kLeaseMs });
  const truth = async () => (await ball.call('sim.truth')).current_a[k];
  const truths = async () => {
    const values = [];
    while (values.length < kTruths) values.push(await truth());
    return values;
  };
  await eventually(`${kCurrentA} A flow ${side}`, async () => {
    const now = await truth();
    // That of the other side may still flow.
    return sign * now > 0.9 * kCurrentA && Math.abs(now - await truth()) < 0.05;
  });
  await passed(ball, kSettlingMs);
  const before = await truths();
  const read = await meanReading(ball, ['current_a'], ({ current_a }) => current_a[k]);
  const trueA = mean([...before, ...await truths()]);
  await ball.call('effect.stop_all');
  return { read, trueA };
}

/** REQUIRES: armed, no current. { supply, current: [x, y, z] }: what is read of 1 V and of 1 A, without the sensors' offsets. */
export async function measureGains(ball, supplyV) {
  const supply = await meanReading(ball, ['supply_v'], ({ supply_v }) => supply_v) / supplyV;
  const current = [];
  for (const [k, [positive, negative]] of kSides.entries()) {
    const [up, down] = [await currents(ball, positive, k, 1), await currents(ball, negative, k, -1)];
    current.push((up.read - down.read) / (up.trueA - down.trueA));
  }
  return { supply, current };
}
