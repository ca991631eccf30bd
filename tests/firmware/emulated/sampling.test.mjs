// SPDX-License-Identifier: MIT
// The windings' currents are converted in the middle of the on-time of the PWM, as the converter's input sees it, whatever the duties, the
// host's phase, and what else the processor has to do; the rules follow at a time that does not depend on it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withBoard } from './fixture.mjs';
import { kMode } from './frames.mjs';

const kPeriodUs = 50;
/** The amplifier, 0.4 us at 400 kHz, and its filter, 100 ohm and 10 nF (firmware/board/reference.net). */
const kInputDelayUs = 1.4;
/** At half the supply the current changes by 4 mA in a microsecond: 0.2 us are 0.8 mA, a twentieth of the converter's step. */
const kMaxOffUs = 0.2;
const kMs = 60;

/** The samples of `ms` milliseconds, in groups of one millisecond each. */
function samples(board, ms) {
  const groups = [];
  let last = -1e9;
  board.onSample = (sample) => {
    if (board.chip.us - last > 300) groups.push([]);
    last = board.chip.us;
    groups.at(-1).push({ ...sample, us: board.chip.us });
  };
  board.run(ms);
  board.onSample = () => {};
  // The first and the last may be cut.
  return groups.slice(1, -1);
}

function assertCentred(groups, ms) {
  assert.ok(groups.length >= ms - 3, `${groups.length} milliseconds of ${ms}`);
  for (const group of groups) {
    assert.deepEqual(group.map(({ winding }) => winding), [0, 1, 2]);
    for (const { winding, offCentreUs } of group)
      assert.ok(Math.abs(offCentreUs - kInputDelayUs) < kMaxOffUs, `winding ${winding}: ${offCentreUs.toFixed(2)} us from the middle`);
    for (let k = 1; k < 3; ++k) {
      const apartUs = group[k].us - group[k - 1].us;
      assert.ok(Math.abs(apartUs - kPeriodUs) < kMaxOffUs, `windings ${k - 1} and ${k}: ${apartUs} us apart`);
    }
  }
}

for (const duty of [[0.03, -0.03, 0.03], [0.19, 0, -0.1], [0.1, -0.15, 0.12]]) {
  test(`each current is converted in the middle of its on-time, once in a millisecond: duties ${duty}`, withBoard((board, driver) => {
    driver.drive(duty);
    const groups = samples(board, kMs);
    assertCentred(groups, kMs);
    for (const { winding, onTimeUs } of groups.flat())
      assert.ok(Math.abs(onTimeUs - Math.abs(duty[winding]) * kPeriodUs) < 0.1, `${onTimeUs} us on`);
    assert.equal(driver.last.mode, kMode.driving);
  }));
}

test('a boost of nearly the whole supply does not move it', withBoard((board, driver) => {
  driver.drive([0.1, 0.1, 0.1]);
  let widest = 0;
  const groups = [];
  for (let i = 0; i < 8; ++i) {
    driver.target = { enable: true, duty: [0.1, 0.1, 0.1], boost: [0.9, -0.9, 0.5] };
    groups.push(...samples(board, 6));
    widest = Math.max(widest, ...groups.flat().map(({ onTimeUs }) => onTimeUs));
  }
  assertCentred(groups, 8 * 4);
  assert.ok(widest > 0.75 * kPeriodUs, `${widest} us`);
}));

test('bridges that reverse and a flood of packets do not move it', withBoard((board, driver) => {
  driver.drive([0.1, -0.1, 0.1]);
  let sign = 1;
  const onOut = board.host.onOut;
  board.host.onOut = (packet, us) => {
    onOut(packet, us);
    if (board.host.outQueue.length < 3) board.host.outQueue.push(Buffer.alloc(64, 0x48));
  };
  const groups = [];
  for (let ms = 0; ms < kMs; ms += 6) {
    driver.target = { enable: true, duty: [0.1 * (sign = -sign), 0.1 * sign, 0.1] };
    groups.push(...samples(board, 6));
  }
  assertCentred(groups, (kMs / 6) * 4);
}));

test('while the board follows a host at any phase, the rules start at a constant interval, without jumps by a PWM period', withBoard((board, driver) => {
  // The sampling points pass through the whole millisecond of the board.
  board.host.frameNanos = 1_002_000;
  driver.drive([0.1, 0, 0], 400);
  board.ticks.length = 0;
  const groups = samples(board, 200);
  assertCentred(groups, 200);
  const first = groups.map(([{ us }]) => us);
  const jumps = first.slice(1).filter((us, i) => Math.abs(us - first[i] - 1000) > 20).length;
  assert.ok(jumps >= 4, `${jumps} jumps of the first sampling point: it did not pass through`);
  const periods = board.ticks.slice(1).map((us, i) => us - board.ticks[i]);
  assert.ok(Math.max(...periods) - Math.min(...periods) < 15, `${Math.min(...periods)}..${Math.max(...periods)} us`);
}));

test('conversions that take longer than a period are late, and none waits for another period', withBoard((board, driver) => {
  board.spiPauseClocks = 8;
  driver.drive([0.1, 0.1, 0.1], 100);
  const groups = samples(board, kMs);
  const lateUs = groups.map((group) => group.map(({ us }, k) => us - group[0].us - k * kPeriodUs));
  assert.ok(groups.length >= kMs - 3 && groups.every((group) => group.length === 3));
  assert.ok(Math.min(...lateUs.map((late) => late[2])) > 1 && Math.max(...lateUs.flat()) < 8, `${lateUs[0]}`);
  assert.equal(driver.last.mode, kMode.driving);
}));
