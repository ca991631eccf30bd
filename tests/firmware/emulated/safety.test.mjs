// SPDX-License-Identifier: MIT
// The rules of the board (daemon/device/board-rules.md) on the flashed image: the tests measure the pins, and the true current of the
// simulator's ball behind them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertDriving, assertNoCurrent, assertSafePins, kFiveAmps, withBoard } from './fixture.mjs';
import { arm, compareValue, kFault, kMode, setPoint } from './frames.mjs';

/** A bit of SimFault. */
const kStuckBridge = 1 << 6;

test('drives nothing before it is armed', withBoard((board, driver) => {
  driver.enumerate();
  driver.target = { enable: true, duty: kFiveAmps };
  board.run(50);
  assert.equal(driver.last.mode, kMode.safe);
  assert.deepEqual(board.events, []);
  assertNoCurrent(board);
}));

test('drives 5 A in a closed loop: what flows is what telemetry says', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  assertDriving(board, driver);
  assert.ok(Math.abs(board.readings.trueMa[0] - driver.last.currentMa[0]) < 150);
  assert.ok(Math.abs(driver.last.supplyMv - 12000) < 200);
  assert.ok(Math.abs(driver.last.sensorC - 25) < 2);
  assert.equal(driver.last.thermistors, 3);
  driver.target = { enable: true, duty: kFiveAmps.map((duty) => -duty) };
  board.run(60);
  assert.ok(board.readings.trueMa[0] < -4000);
  assert.ok(Math.abs(board.readings.trueMa[0] - driver.last.currentMa[0]) < 150);
}));

test('the fan is measured by its tach', withBoard((board, driver) => {
  driver.enumerate();
  driver.target = { enable: false, fan: 255 };
  board.run(3000);
  const rpm = 30e6 / board.readings.tachUs;
  assert.ok(rpm > 500 && Math.abs(driver.last.fanRpm - rpm) < 0.03 * rpm, `${driver.last.fanRpm} for ${rpm}`);
}));

test('the dead-man acts 100 ms +- 1 ms after the last set-point, at the pins', withBoard((board, driver) => {
  let lastSent = 0;
  const record = (packet, us) => { lastSent = us; };
  board.host.onOut = record;
  for (let round = 0; round < 16; ++round) {
    if (round === 0) driver.drive(kFiveAmps);
    else {
      driver.sending = true;
      board.run(3.3);
      driver.arm();
      board.run(60);
    }
    assertDriving(board, driver);
    driver.sending = false;
    // The last one, at another phase of the board's millisecond in each round; one before it may still be in transfer.
    board.after(60 * round, () => board.host.outQueue.push(setPoint(++driver.sequence, driver.target)));
    let last = lastSent;
    board.host.onOut = (packet, us) => { last = us; };
    board.events.length = 0;
    board.run(120);
    board.host.onOut = record;
    assert.equal(board.events[0].awake, false);
    const ms = (board.events[0].us - last) / 1000;
    assert.ok(ms > 99 && ms < 101, `${ms} ms`);
    assertSafePins(board);
    assertNoCurrent(board);
    assert.equal(driver.last.mode, kMode.latched);
    assert.ok(driver.last.faults & kFault.deadMan);
  }
}));

test('a latched board stays so whatever set-points come, until it is armed anew', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  driver.sending = false;
  board.run(120);
  driver.sending = true;
  board.run(200);
  assert.equal(driver.last.mode, kMode.latched);
  // The same count again does not arm.
  board.host.outQueue.push(arm(++driver.sequence, driver.armCount));
  board.run(20);
  assertSafePins(board);
  assertNoCurrent(board);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

/** Of the duties below: one way, and back. */
const [kFiveAmpsCompare, kBackCompare] = [0.19, 0.05].map((duty) => compareValue(Math.round(duty * 32767)));

test('a bridge turns round at the end of a PWM period, together with its new duty', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const seen = [];
  board.mcu.gpio[3].addListener(() => seen.push(board.pins().pwm[0]));
  for (let turn = 1; turn <= 20; ++turn) {
    driver.target = { enable: true, duty: [turn % 2 === 1 ? -0.05 : 0.19, 0, 0] };
    board.run(2.05); // at a different phase of the period each time
  }
  assert.ok(seen.length >= 18, `${seen.length} turns`);
  seen.forEach((compare, i) => assert.equal(compare, i % 2 === 0 ? kBackCompare : kFiveAmpsCompare));
}));

/** Puts slice 0, and slice 1 with it, to the cycle `count` of the 6250 of a period. */
const setCounters = (board, count) => board.mcu.pwm.channels.slice(0, 2).forEach(({ timer }) => timer.set(count));

for (const [when, begin] of [
  ['just after its compare value', (board, at) => { board.onApply = () => at(6247); }],
  ['just before it', (board, at) => {
    const { pwm } = board.mcu;
    const read = pwm.readUint32.bind(pwm);
    // The first reading of the counter, with a few cycles left.
    pwm.readUint32 = (offset) => {
      if (offset === 8) at(6230);
      return read(offset);
    };
  }],
]) {
  test(`a period that ends ${when} is written is that in which a bridge turns round: no period has the duty of one direction in the other`, withBoard((board, driver) => {
    driver.drive(kFiveAmps);
    let forced = 0;
    begin(board, (count) => {
      if (forced === 0 && board.mcu.gpio[3].outputValue === false && driver.target.duty[0] < 0) {
        ++forced;
        setCounters(board, count);
      }
    });
    const turned = [];
    board.mcu.gpio[3].addListener(() => turned.push({ us: board.chip.us, compare: board.pins().pwm[0] }));
    driver.target = { enable: true, duty: [-0.05, 0, 0] };
    board.run(6);
    assert.equal(forced, 1);
    assert.equal(turned.length, 1);
    const applied = board.applied.filter(({ value }) => value === kBackCompare);
    assert.equal(turned[0].compare, kBackCompare, 'the new duty');
    assert.ok(turned[0].us - applied[0].us < 5, `${turned[0].us - applied[0].us} us of the new duty in the old direction`);
  }));
}

test('a bridge that drives while it should sleep loses its supply', withBoard((board, driver) => {
  driver.enumerate();
  board.run(30);
  assert.equal(board.pins().closed, true);
  board.plant.command(`faults ${kStuckBridge} 0`);
  board.run(100);
  assert.equal(board.pins().closed, false);
  assert.ok(driver.last.faults & kFault.stuckBridge);
  assertNoCurrent(board);
}));

test('a program that hangs is reset by the watchdog within 22 ms, and is safe after it', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const us = board.chip.us;
  board.chip.hang();
  board.run(25, () => board.chip.resets === 1);
  assert.equal(board.chip.resets, 1);
  assert.ok(board.chip.resetUs - us < 21e3);
  board.run(5);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  driver.enumerate();
  board.run(20);
  assert.equal(driver.last.mode, kMode.safe);
  assertNoCurrent(board);
}));

test('a processor in lock-up is reset by the watchdog within 22 ms, and is safe after it', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const us = board.chip.us;
  board.chip.lockUp();
  board.run(25, () => board.chip.resets === 1);
  assert.equal(board.chip.resets, 1);
  assert.ok(board.chip.resetUs - us < 21e3);
  board.run(20);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
}));

test('a fault of the processor leaves the safe pins at once, then a reset', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.chip.fault();
  board.run(0.2);
  assertSafePins(board);
  board.run(10);
  assert.equal(board.chip.resets, 0);
  assertNoCurrent(board);
  board.run(12);
  assert.equal(board.chip.resets, 1);
  assertNoCurrent(board);
}));

test('a fault of the processor before its program is in SRAM leaves the pins as in reset', withBoard((board) => {
  board.run(0.2);
  assert.equal(board.chip.core.PC >>> 28, 1, 'it runs in the flash');
  board.chip.fault();
  board.run(30);
  assert.equal(board.chip.core.PC >>> 28, 1);
  assert.equal(board.pins().awake, false);
  assert.equal(board.pins().closed, false);
  assertNoCurrent(board);
}));

test('a flood of bad packets neither drives, nor feeds the dead-man, nor holds the board up', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  driver.sending = false;
  board.run(1);
  const { us } = board.chip;
  const newest = { duty: [1, 1, 1] };
  const kBad = [
    () => Buffer.alloc(64, 0x48),
    () => setPoint(++driver.sequence, newest).subarray(0, 63),
    () => Buffer.alloc(1),
    () => Object.assign(setPoint(++driver.sequence, newest), { 30: 1 }),
    () => setPoint(1, newest),
  ];
  let sent = 0;
  let max = 0;
  const fill = () => {
    while (board.host.outQueue.length < 8) board.host.outQueue.push(kBad[sent++ % kBad.length]());
    max = Math.max(max, board.trueMa);
  };
  const ticks = board.ticks.length;
  board.events.length = 0;
  board.run(150, () => void fill());
  assert.ok(sent > 500, `${sent} packets`);
  assert.ok(max < 6000, `${max} mA`);
  assert.ok(board.events[0].us - us < 101e3, 'asleep');
  assert.ok(board.ticks.length - ticks >= 149, 'every millisecond was kept');
  assert.equal(driver.last.mode, kMode.latched);
  assert.ok(driver.last.refused > 400);
  assertSafePins(board);
  assertNoCurrent(board);
  assert.equal(board.chip.resets, 0);
}));
