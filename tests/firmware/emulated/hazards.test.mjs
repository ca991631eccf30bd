// SPDX-License-Identifier: MIT
// The hazards of the safety table that the board itself guards against, each on the flashed image, driving the simulator's ball: bridges
// asleep in time, no current in the ball, and none until it is armed without the hazard. The table is in safety-table.md.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertDriving, assertNoCurrent, assertSafePins, kFiveAmps, withBoard } from './fixture.mjs';
import { kFault, kMode, limits } from './frames.mjs';

/** Bits of SimFault. */
const kSim = { open: 1, short: 2, bridgeFault: 1 << 7, currentHalf: 1 << 11, supplyLow: 1 << 12 };
/** SimulatorErrorKind. */
const kError = { currentGain: 0, supplyGain: 2, pwmStuck: 5, thermistorK: 6 };
const kThirteenAmps = [0.5, 0, 0];
const kWindings = [0, 1, 2];

const faults = (bits, winding = 0) => ({ board }) => board.plant.command(`faults ${bits} ${winding}`);
const error = (kind, winding, value) => ({ board }) => board.plant.command(`error ${kind} ${winding} ${value}`);
/** The converter's value of the amplifier of winding x. */
const shown = (value) => ({ board }) => { board.shownCurrent = value; };

/**
 * `notBeforeMs`: one disturbed reading is ignored. `again`: the hazard ends with the current, so the board can be armed. `open`: it opens the
 * supply switch too.
 */
const kHazards = [
  ...kWindings.map((k) => ({ what: `thermistor ${k} open`, begin: faults(kSim.open, k), fault: kFault.sensorOpen, notBeforeMs: 19, withinMs: 25 })),
  ...kWindings.map((k) => ({ what: `thermistor ${k} shorted`, begin: faults(kSim.short, k), fault: kFault.sensorShort, notBeforeMs: 19, withinMs: 25 })),
  ...kWindings.map((k) => ({ what: `thermistor ${k} above 75 C`, begin: error(kError.thermistorK, k, 55), fault: kFault.overHeat, notBeforeMs: 49, withinMs: 62 })),
  { what: 'too hot', begin: ({ board }) => board.plant.command('heat 80'), fault: kFault.overHeat, notBeforeMs: 49, withinMs: 62 },
  ...kWindings.map((k) => ({ what: `bridge ${k} reports a fault`, begin: faults(kSim.bridgeFault, k), fault: kFault.bridge, notBeforeMs: 2, withinMs: 5 })),
  { what: 'a PWM line is stuck', begin: error(kError.pwmStuck, 1, 0.4), fault: kFault.unexpectedCurrent, withinMs: 30, again: true },
  { what: 'supply below 6.5 V', begin: faults(kSim.supplyLow), fault: kFault.supply, notBeforeMs: 9, withinMs: 13 },
  { what: 'supply above 18 V', begin: error(kError.supplyGain, 0, 1.6), fault: kFault.supply, notBeforeMs: 9, withinMs: 13, open: true },
  { what: 'an amplifier’s line is open', begin: shown(0), fault: kFault.unexpectedCurrent, withinMs: 8, again: true },
  { what: 'the converter does not answer', begin: ({ board }) => { board.converterResponds = false; }, fault: kFault.unexpectedCurrent, withinMs: 8 },
  { what: 'an amplifier’s line is at its supply', begin: shown(4095), fault: kFault.unexpectedCurrent, withinMs: 8, again: true },
  { what: 'an amplifier shows zero at 13 A', duty: kThirteenAmps, begin: shown(2048), fault: kFault.unexpectedCurrent, withinMs: 24, again: true },
  {
    what: 'an amplifier keeps what it shows', begin: ({ board, driver }) => {
      board.shownCurrent = board.readings.current[0];
      driver.target = { enable: true, duty: [0, 0, 0] };
    }, fault: kFault.unexpectedCurrent, withinMs: 30, again: true,
  },
  { what: 'an amplifier shows half of 13 A', duty: kThirteenAmps, begin: faults(kSim.currentHalf), fault: kFault.unexpectedCurrent, withinMs: 24, again: true },
  { what: 'an amplifier shows 70 % of 13 A', duty: kThirteenAmps, begin: error(kError.currentGain, 0, 0.7), fault: kFault.unexpectedCurrent, notBeforeMs: 500, withinMs: 2000, again: true },
  { what: 'an amplifier shows twice 5 A', begin: error(kError.currentGain, 0, 2), fault: kFault.unexpectedCurrent, withinMs: 24, again: true },
  {
    what: 'more than 16.5 A', begin: ({ driver }) => { driver.target = { enable: true, duty: [0.8, 0, 0] }; },
    fault: kFault.overCurrent, notBeforeMs: 49, withinMs: 60, again: true,
  },
  {
    what: 'more than the host’s tighter limit', begin: ({ board, driver }) => {
      board.host.outQueue.push(limits(++driver.sequence, { currentMa: 4000 }));
    }, fault: kFault.overCurrent, notBeforeMs: 49, withinMs: 54, again: true,
  },
  {
    // 1 % of the budget of a winding is 96 A^2 s; at 25 A^2 it is used up after about 4 s.
    what: 'the I²t budget is spent', begin: ({ board, driver }) => {
      board.host.outQueue.push(limits(++driver.sequence, { heat: 10 }));
    }, fault: kFault.heatBudget, withinMs: 4500,
  },
];

for (const { what, duty = kFiveAmps, begin, fault, notBeforeMs = 0, withinMs, again = false, open = false } of kHazards) {
  test(`${what}: asleep within ${withinMs} ms, no current`, withBoard((board, driver) => {
    driver.drive(duty);
    assertDriving(board, driver);
    board.events.length = 0;
    const { us } = board.chip;
    begin({ board, driver });
    board.run(withinMs + 1, () => board.events.length > 0);
    const tookMs = (board.chip.us - us) / 1000;
    assert.ok(board.events.length > 0 && tookMs <= withinMs, `asleep after ${board.events.length > 0 ? tookMs : 'never'} ms`);
    assert.ok(tookMs >= notBeforeMs, `asleep after ${tookMs} ms already`);
    board.run(20); // 8 ms to decay from 16.5 A through the diodes
    assert.equal(driver.last.mode, kMode.latched);
    assert.ok(driver.last.faults & fault, `faults ${driver.last.faults}`);
    assertSafePins(board);
    assertNoCurrent(board);
    if (open) assert.equal(board.pins().closed, false, 'the supply switch');
    console.log(`${what}: asleep after ${tookMs.toFixed(1)} ms`);
    if (again) return;
    driver.arm();
    assert.equal(driver.last.mode, kMode.latched, 'armed in spite of it');
    assertNoCurrent(board);
  }));
}

/** 12 V of the simulated ball, as the converter reads them. */
const supplyAt = (board, volts) => board.plant.command(`error ${kError.supplyGain} 0 ${volts / 12}`);

test('the supply switch closes 20 ms after a supply of 6.5 to 18 V has come, with no supply and with 24 V it stays open', withBoard((board, driver) => {
  supplyAt(board, 24);
  driver.enumerate();
  driver.arm();
  driver.target = { enable: true, duty: kFiveAmps };
  board.run(200);
  assert.equal(board.pins().closed, false, 'at 24 V');
  assert.ok(driver.last.faults & kFault.supply);
  supplyAt(board, 0);
  board.run(100);
  assert.equal(board.pins().closed, false, 'without a supply');
  assertSafePins(board);
  assertNoCurrent(board);
  supplyAt(board, 12);
  board.run(15);
  assert.equal(board.pins().closed, false, 'not yet');
  board.run(10);
  assert.equal(board.pins().closed, true, 'at 12 V');
  // A supply that breaks down keeps it closed: a winding's current may be the cause.
  supplyAt(board, 5);
  board.run(50);
  assert.equal(board.pins().closed, true, 'at 5 V');
  supplyAt(board, 12);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

/** The supply's amplifier at 0.5 A: 100 mV/A of the converter's 3.3 V. */
const kHalfAnAmpere = Math.round(0.05 / 3.3 * 4096);

test('capacitors that charge for 150 ms when the supply switch closes are no stuck bridge; a current that flows on is one', withBoard((board, driver) => {
  supplyAt(board, 0);
  driver.enumerate();
  board.run(50);
  const close = () => {
    supplyAt(board, 12);
    board.run(30, () => board.pins().closed);
    assert.equal(board.pins().closed, true);
    board.shownShunt = kHalfAnAmpere;
  };
  close();
  board.run(150);
  assert.equal(board.pins().closed, true, 'charging');
  assert.equal(driver.last.faults & kFault.stuckBridge, 0);
  board.shownShunt = undefined;
  board.run(60);
  driver.drive(kFiveAmps);
  assertDriving(board, driver);
  supplyAt(board, 24);
  board.run(50);
  assert.equal(board.pins().closed, false);
  close();
  board.run(230);
  assert.equal(board.pins().closed, false, 'it flows on');
  assert.ok(driver.last.faults & kFault.stuckBridge);
  assertSafePins(board);
  assertNoCurrent(board);
}));

test('a fault of the processor before the supply is known leaves the supply switch open', withBoard((board, driver) => {
  supplyAt(board, 24);
  driver.enumerate();
  board.chip.fault();
  board.run(1);
  assertSafePins(board);
  assert.equal(board.pins().closed, false);
}));

test('the host’s machine stops, without a frame of the bus: asleep 100 ms +- 1 ms after the last set-point, no current, none when it is back', withBoard((board, driver) => {
  let last = 0;
  board.host.onOut = (packet, us) => { last = us; };
  driver.drive(kFiveAmps);
  assertDriving(board, driver);
  board.host.frames = false;
  driver.sending = false;
  board.events.length = 0;
  board.run(120, () => board.events.length > 0);
  const ms = (board.events[0].us - last) / 1000;
  console.log(`the host's machine stops: asleep after ${ms.toFixed(2)} ms`);
  assert.ok(ms > 99 && ms < 101, `${ms} ms`);
  board.run(20);
  assertSafePins(board);
  assertNoCurrent(board);
  // Another machine, without knowledge of an armed ball.
  board.host.frames = true;
  driver.sending = true;
  driver.enumerate();
  board.run(200);
  assert.equal(driver.last.mode, kMode.latched);
  assert.ok(driver.last.faults & kFault.deadMan);
  assertNoCurrent(board);
}));

test('suspended and resumed before the dead-man’s time, the board drives on; after it, it does not', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const pause = (ms) => {
    board.host.frames = false;
    board.run(ms);
    assert.ok(board.host.suspended);
    board.host.frames = true;
    board.run(10);
  };
  pause(50);
  assertDriving(board, driver);
  pause(110);
  board.run(200);
  assert.equal(driver.last.mode, kMode.latched);
  assertSafePins(board);
  assertNoCurrent(board);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

test('enumerated anew by a daemon that has just begun: asleep with its first set-point, no current', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  driver.target = { enable: false };
  board.events.length = 0;
  board.host.reset();
  board.host.enumerate(9);
  board.run(5);
  assert.equal(board.events[0]?.awake, false);
  board.run(15);
  assertNoCurrent(board);
  // The host continues with its own sequence numbers, which are older than the last one accepted by the board.
  driver.sequence = 0;
  driver.target = { enable: true, duty: kFiveAmps };
  board.run(200);
  assert.equal(driver.last.mode, kMode.latched);
  assert.ok(driver.last.faults & kFault.deadMan);
  assertSafePins(board);
  assertNoCurrent(board);
}));

test('a thermistor opens under a flood of packets: the rules are kept', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const flood = () => { while (board.host.outQueue.length < 8) board.host.outQueue.push(Buffer.alloc(64, 0x48)); };
  board.run(60, () => void flood());
  board.plant.command(`faults ${kSim.open} 1`);
  board.events.length = 0;
  const { us } = board.chip;
  const ticks = board.ticks.length;
  board.run(150, () => void flood());
  assert.ok(board.events.length > 0 && board.events[0].us - us < 25e3, 'asleep');
  // None is left out. The set-points come late behind the other packets, which may move the tick: by 5 us each time, once by 500 us.
  assert.ok(board.ticks.length - ticks >= 149, `${board.ticks.length - ticks} milliseconds`);
  assertSafePins(board);
  assertNoCurrent(board);
}));

test('a brown-out of the core, which works only from 0.99 V on: reset at once, no current, none before it is armed', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.chip.sagCore(0.98);
  board.run(5);
  assertDriving(board, driver);
  board.chip.sagCore(0.91);
  board.run(0.1);
  assert.equal(board.chip.resets, 1);
  assert.equal(board.pins().awake, false);
  board.run(20);
  assertNoCurrent(board);
  driver.enumerate();
  board.run(50);
  assert.equal(driver.last.mode, kMode.safe);
  assertNoCurrent(board);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

for (const [what, stop] of [
  ['the converter’s clock stops: a loop', ({ mcu }) => { mcu.spi[0].onTransmit = () => {}; }],
  ['the sampling points fail to come: a sleep', ({ mcu }) => { mcu.pwm.channels[2].timer.enable = false; }],
])
  test(`${what} that waits for it is reset within 22 ms, and the bridges sleep`, withBoard((board, driver) => {
    driver.drive(kFiveAmps);
    const { us } = board.chip;
    stop(board);
    board.run(25, () => board.chip.resets === 1);
    assert.equal(board.chip.resets, 1);
    assert.ok(board.chip.resetUs - us < 22e3, `${board.chip.resetUs - us} us`);
    board.run(10);
    assert.equal(board.pins().awake, false);
    assertNoCurrent(board);
  }));
