// SPDX-License-Identifier: MIT
// The real hedgehogd on the flashed image: through the public protocol, down to the current in the simulated ball. Assertions are in the
// board's own time.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DaemonOnBoard, eventually } from './daemon.mjs';

/** From the last set-point at the board to the edge of the pin SLP. */
const kDeadManUs = [99e3, 101e3];
/** 5 L/R of a winding, and a millisecond. */
const kDecayUs = 19e3;

const withDaemon = (body, options) => async () => {
  const daemon = await DaemonOnBoard.start(options);
  try {
    await body(daemon, daemon.ball);
  } catch (error) {
    error.message += `\n${daemon.log}\n${daemon.trace().map((line) => JSON.stringify(line)).join('\n')}`;
    throw error;
  } finally {
    await daemon.close();
  }
};

async function ended(ball, start) {
  const events = ball.events(['effect_ended']);
  const first = events.next();
  await start();
  const { value } = await first;
  await events.return();
  return value;
}

const trueCurrent = async (ball) => (await ball.call('sim.truth')).current_a;

/** A hold of several amperes, measured in the windings. */
async function drive(daemon) {
  await daemon.state('armed');
  await daemon.ball.hold('left', { slot: 'test', current_a: 8, lease_ms: 10_000 });
  await eventually('8 A flow to the left', async () => Math.abs((await trueCurrent(daemon.ball))[1]) > 7.5);
}

/** The last line of this event, and the next line of event `zero`. */
function ending(lines, event = 'asleep') {
  const at = lines.findLastIndex((line) => line.event === event);
  assert.ok(at >= 0, event);
  const zero = lines.slice(at).find((line) => line.event === 'zero');
  assert.ok(zero, 'no current any more');
  return { asleep: lines[at], zero };
}

function assertDeadMan(lines) {
  const { asleep, zero } = ending(lines);
  assert.ok(asleep.since_set_point_us > kDeadManUs[0] && asleep.since_set_point_us < kDeadManUs[1], `${asleep.since_set_point_us} us`);
  assert.ok(zero.us - asleep.us < kDecayUs, `${zero.us - asleep.us} us`);
  assert.equal(zero.fan, 4999);
}

test('a pulse and a circle have the requested currents', withDaemon(async (daemon, ball) => {
  const status = await daemon.state('armed');
  assert.ok(Math.abs(status.supply_v - 12) < 0.3);
  assert.equal(status.temperature_c.sensors.length, 3);
  // The board drops at most a frame when its millisecond takes over the phase of a new host.
  const { lost } = (await ball.status()).link;
  assert.ok(lost <= 1, `${lost} frames`);
  const pulse = await ended(ball, () => ball.pulse('left', { current_a: 10, duration_ms: 300 }));
  assert.equal(pulse.reason, 'completed');
  const [x, y, z] = (await eventually('the bridges sleep', () => daemon.trace().find((line) => line.event === 'asleep'))).peak_ma;
  assert.ok(y > 9700 && y < 10300, `${y} mA in y`);
  assert.ok(Math.abs(x) < 200 && Math.abs(z) < 200, `${x}, ${z} mA in x, z`);

  const circle = await ended(ball, () => ball.circle('up', { current_a: 6, duration_ms: 1500 }));
  assert.equal(circle.reason, 'completed');
  assert.equal((await ball.status()).link.lost, lost);
  const lines = await daemon.stop();
  const peak = lines.filter((line) => line.event === 'asleep').at(-1).peak_ma.map(Math.abs);
  assert.ok(peak[0] > 5500 && peak[1] > 5500 && peak[2] < 500, `${peak} mA`);
  assert.ok(!lines.some((line) => line.event === 'reset'));
}));

test('a daemon that is killed leaves no current after the dead-man’s 100 ms', withDaemon(async (daemon) => {
  await drive(daemon);
  assertDeadMan(await daemon.stop('SIGKILL'));
}));

test('a daemon that ends puts the bridges to sleep itself', withDaemon(async (daemon) => {
  await drive(daemon);
  const { asleep } = ending(await daemon.stop('SIGTERM'));
  assert.ok(asleep.since_set_point_us < 5e3, `${asleep.since_set_point_us} us`);
}));

test('a host that does nothing for 150 ms finds the ball latched, and arms it again', withDaemon(async (daemon, ball) => {
  await drive(daemon);
  assertDeadMan(await daemon.control('alone 150'));
  const status = await daemon.state('tripped');
  assert.equal(status.reason, 'board_dead_man');
  assert.ok(Math.hypot(...(await trueCurrent(ball))) < 0.1);
  await eventually('it can be armed', () => ball.call('device.arm').then((response) => response.state === 'armed', () => false));
  await drive(daemon);
}));

test('a thermistor that breaks trips, and the ball stays off until it is whole and armed', withDaemon(async (daemon, ball) => {
  await drive(daemon);
  await ball.call('sim.set', { fault: { faults: ['sensor_open'] } });
  const status = await daemon.state('tripped');
  assert.equal(status.last_trip.reason, 'sensor_open');
  await eventually('no current', async () => Math.hypot(...(await trueCurrent(ball))) < 0.1);
  await assert.rejects(ball.call('device.arm'));
  await assert.rejects(ball.hold('left', { slot: 'test', current_a: 8, lease_ms: 10_000 }));
  await ball.call('sim.set', { fault: { faults: [] } });
  await eventually('it can be armed', () => ball.call('device.arm').then((response) => response.state === 'armed', () => false));
  await drive(daemon);
}));

test('a firmware that hangs is reset by its watchdog, and the daemon does not drive it unasked', withDaemon(async (daemon, ball) => {
  await drive(daemon);
  const lines = await daemon.control('hang');
  await eventually('the reset', () => daemon.trace().some((line) => line.event === 'reset'));
  await eventually('no current', async () => Math.hypot(...(await trueCurrent(ball))) < 0.1);
  assert.ok(lines.every((line) => line.event !== 'exit'));
  await eventually('the ball is not armed', async () => (await ball.status()).state !== 'armed');
  await eventually('it can be armed', () => ball.call('device.arm').then((response) => response.state === 'armed', () => false));
  await drive(daemon);
}));

test('USB that is pulled ends the current, and the board is found again', withDaemon(async (daemon, ball) => {
  await drive(daemon);
  const lines = await daemon.control('unplug 300');
  const { asleep, zero } = ending(lines, 'unplugged');
  const plugged = lines.find(({ event }) => event === 'plugged');
  assert.ok(zero.us - asleep.us < kDecayUs, `${zero.us - asleep.us} us`);
  assert.deepEqual([plugged.awake, plugged.closed, plugged.fan], [false, false, 4999]);
  await eventually('the ball is not armed', async () => (await ball.status()).state !== 'armed');
  await eventually('it can be armed', () => ball.call('device.arm').then((response) => response.state === 'armed', () => false));
  await drive(daemon);
}));

test('a ball that is armed is refused its boot loader; one that is not goes into the ROM’s, and cannot be armed there', withDaemon(async (daemon, ball) => {
  await drive(daemon);
  await assert.rejects(ball.call('device.enter_boot_loader'), /armed/);
  assert.equal((await daemon.ctl('stop')).code, 0);
  await eventually('no current', async () => Math.hypot(...(await trueCurrent(ball))) < 0.1);
  const before = daemon.trace().length;
  const { state } = await ball.call('device.enter_boot_loader');
  assert.equal(state, 'absent');
  const status = await ball.status();
  assert.equal(status.reason, 'boot_loader');
  assert.equal(status.last_trip, null);
  await assert.rejects(ball.call('device.arm'));
  const entered = await eventually('it enters the ROM', () => daemon.trace().slice(before).find((line) => line.event === 'boot_loader'));
  assert.deepEqual([entered.awake, entered.closed, entered.fan], [false, false, 4999]);
  assert.ok(Math.hypot(...(await trueCurrent(ball))) < 0.1);
}));
