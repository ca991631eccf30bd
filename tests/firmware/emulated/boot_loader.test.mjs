// SPDX-License-Identifier: MIT
// The command that reboots into the boot loader is accepted only while the bridges are asleep.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertDriving, assertNoCurrent, kFiveAmps, withBoard } from './fixture.mjs';
import { bootLoader, kMode } from './frames.mjs';

const request = (board, driver, key) => board.host.outQueue.push(bootLoader(++driver.sequence, key));

function assertInBootLoader(board) {
  assert.ok(board.chip.bootLoader, 'it has called the ROM');
  const { lamp, disabled, pinsBefore } = board.chip.bootLoader;
  assert.deepEqual([lamp, disabled], [0, 0], 'no lamp, both of its interfaces');
  assert.deepEqual([pinsBefore.awake, pinsBefore.direction], [false, 0], 'safe before it');
  assert.equal(board.pins().awake, false);
  assert.equal(board.pins().fan, 4999, 'the fan’s line is open');
  assert.equal(board.pins().closed, false, 'the supply switch is off by its resistor');
  assert.equal(board.host.connected, false);
  assertNoCurrent(board);
}

test('a board that was never armed enters its boot loader', withBoard((board, driver) => {
  driver.enumerate();
  driver.target = { enable: true, duty: kFiveAmps };
  board.run(20);
  assert.equal(driver.last.mode, kMode.safe);
  request(board, driver);
  board.run(5);
  assertInBootLoader(board);
  board.run(50);
  assertInBootLoader(board);
}));

test('a latched one enters it too', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  driver.sending = false;
  board.run(140);
  assert.equal(driver.last.mode, kMode.latched);
  request(board, driver);
  board.run(5);
  assertInBootLoader(board);
}));

test('a driving board refuses and continues; one that is armed and asleep enters it 20 ms later', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const { refused } = driver.last;
  request(board, driver);
  board.run(20);
  assert.equal(board.chip.bootLoader, undefined);
  assertDriving(board, driver);
  assert.equal(driver.last.refused, refused + 1);
  driver.target = { enable: false };
  board.run(10);
  assert.equal(driver.last.mode, kMode.ready);
  request(board, driver);
  board.run(15);
  assert.equal(board.chip.bootLoader, undefined);
  assert.equal(driver.last.mode, kMode.ready);
  request(board, driver);
  board.run(5);
  assertInBootLoader(board);
}));

test('a frame with another key is refused', withBoard((board, driver) => {
  driver.enumerate();
  const { refused } = driver.last;
  request(board, driver, 0x12345678);
  board.run(20);
  assert.equal(board.chip.bootLoader, undefined);
  assert.equal(driver.last.refused, refused + 1);
}));
