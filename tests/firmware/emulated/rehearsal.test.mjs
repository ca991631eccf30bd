// SPDX-License-Identifier: MIT
// The steps of the guides (firmware/board/bring-up.md from step 6 on, daemon/device/bringing-up-a-ball.md) with the programs that they
// name, on the flashed image and a ball whose windings and electronics are drawn at random within their tolerances: the output of each
// command, and the currents. HEDGEHOG_FIRMWARE_REHEARSAL=thermal: also `calibrate --thermal`, half an hour of the ball's time.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { DaemonOnBoard, eventually } from './daemon.mjs';

const kSeed = 15; // for the electronics' parts
/** Within 3 % of the design. */
const kDrawn = { name: 'drawn', r25_ohm: [0.459, 0.441, 0.4545], inductance_h: 0.00153 };
/** Voltage and current are read within 2 % each, the temperature within 1 K (0.4 %). */
const kOhmTolerance = 0.045;
const kThermal = process.env.HEDGEHOG_FIRMWARE_REHEARSAL === 'thermal';

const folder = mkdtempSync(join(tmpdir(), 'hedgehog-rehearsal-'));
after(() => rmSync(folder, { recursive: true }));
const found = join(folder, 'ball-7.json');

const start = (devices, device) => DaemonOnBoard.start({
  devices: { drawn: kDrawn, ...devices }, config: { ...(device && { device }), simulator: { device: 'drawn', seed: kSeed } },
});

async function withDaemon(daemon, body) {
  try {
    await body(daemon, daemon.ball);
    assert.ok(!daemon.trace().some((line) => line.event === 'reset'));
  } catch (error) {
    error.message += `\n${daemon.log}`;
    throw error;
  } finally {
    await daemon.stop();
    daemon.close();
  }
}

/** Runs a command that must succeed; returns its output. */
async function does(daemon, ...words) {
  const { code, out, err } = await daemon.ctl(...words);
  assert.equal(code, 0, `${words.join(' ')}: ${out}${err}`);
  console.log(`$ hedgehogctl ${words.join(' ')}\n${out}`);
  return out;
}
const trueCurrents = async (ball) => (await ball.call('sim.truth')).current_a;

test('a ball that has never been driven is brought up with the commands of the guides, as far as its device file', async () => {
  await withDaemon(await start(), async (daemon, ball) => {
    // bring-up.md, step 6
    await daemon.state('armed');
    assert.match(await does(daemon, 'status'), /armed/);
    const { supply_v, temperature_c } = await ball.status();
    assert.ok(Math.abs(supply_v - 12) < 0.3, `${supply_v} V`);
    for (const celsius of temperature_c.sensors) assert.ok(Math.abs(celsius - 25) < 1.5, `${temperature_c.sensors}`);
    await ball.call('sim.set', { fault: { faults: ['sensor_open'] } });
    await daemon.state('tripped');
    assert.match(await does(daemon, 'status'), /sensor_open/);
    const refused = await daemon.ctl('arm');
    assert.notEqual(refused.code, 0);
    assert.match(refused.err, /thermistor|sensor/);
    await ball.call('sim.set', { fault: { faults: [] } });
    await eventually('it can be armed', async () => (await daemon.ctl('arm')).code === 0);
    // step 7, and step 3 of the daemon's guide
    await ball.hold('up', { slot: 'test', current_a: 1, lease_ms: 10_000 });
    await eventually('1 A flows up', async () => Math.abs((await trueCurrents(ball))[2]) > 0.9);
    const lines = await daemon.control('alone 150');
    const asleep = lines.find((line) => line.event === 'asleep');
    assert.ok(asleep.since_set_point_us > 99e3 && asleep.since_set_point_us < 101e3, `${asleep.since_set_point_us} us`);
    assert.match(await does(daemon, 'status'), /board_dead_man/);
    assert.ok(Math.hypot(...(await trueCurrents(ball))) < 0.1);
    await eventually('it can be armed', async () => (await daemon.ctl('arm')).code === 0);
    // step 4
    const words = ['calibrate', '--name', 'ball-7', '--pushed', 'x=front,y=left,z=up', '--out', found];
    assert.match(await does(daemon, ...words, ...(kThermal ? ['--thermal'] : [])), /ball-7\.json/);
  });
  const file = JSON.parse(readFileSync(found, 'utf8').replace(/^\s*\/\/.*$/gm, ''));
  assert.equal(file.name, 'ball-7');
  kDrawn.r25_ohm.forEach((ohm, k) => assert.ok(Math.abs(file.r25_ohm[k] - ohm) < kOhmTolerance * ohm, `winding ${k}: ${file.r25_ohm[k]} ohm for ${ohm}`));
  assert.ok(Math.abs(file.inductance_h - kDrawn.inductance_h) < 0.1 * kDrawn.inductance_h);
  if (kThermal) assert.ok(Array.isArray(file.thermal.winding_j_k) || file.thermal.winding_j_k > 0);
});

test('with that file it gives its first push', async () => {
  const file = JSON.parse(readFileSync(found, 'utf8').replace(/^\s*\/\/.*$/gm, ''));
  await withDaemon(await start({ 'ball-7': file }, 'ball-7'), async (daemon) => {
    await daemon.state('armed');
    for (const [direction, k] of [['front', 0], ['left', 1], ['up', 2]]) {
      const before = daemon.trace().length;
      await does(daemon, 'pulse', direction, '--current-a', '10', '--duration-ms', '300');
      const line = await eventually('the bridges sleep', () => daemon.trace().slice(before).find(({ event }) => event === 'asleep'));
      // The remaining current of this pulse must not count for the next one.
      await eventually('no current', () => daemon.trace().slice(before).some(({ event }) => event === 'zero'));
      line.peak_ma.forEach((ma, i) => assert.ok(i === k ? ma > 9500 && ma < 10_500 : Math.abs(ma) < 300, `${direction}: ${line.peak_ma} mA`));
    }
    assert.equal((await daemon.ball.status()).last_trip, null);
  });
});
