// SPDX-License-Identifier: MIT
// The image as a USB device.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertDriving, assertNoCurrent, kFiveAmps, withBoard } from './fixture.mjs';
import { kFault, kMode } from './frames.mjs';

const hex = (bytes) => Buffer.from(bytes).toString('hex');

test('sends the descriptors of daemon/device/board-protocol.md', withBoard((board, driver) => {
  const { device, configuration, strings } = driver.enumerate();
  assert.equal(hex(device), '120110020000004009120100020101020301');
  assert.equal(hex(configuration), '09022000010100c0320904000002ff4801000705010240000007058102400000');
  assert.deepEqual(strings, ['Hedgehog', 'Hedgehog driver board', 'E4628C11275A3F2B']);
}));

test('has a serial number of its own kind where the flash has none', withBoard((board, driver) => {
  assert.equal(driver.enumerate().strings[2], 'NO-FLASH-ID');
}, { flashId: Array(8).fill(0xff) }));

test('asks Windows for WinUSB', withBoard((board, driver) => {
  driver.enumerate();
  const bos = board.host.descriptor(15);
  assert.equal(hex(bos), '050f2100011c100500df60ddd88945c74c9cd2659d9e648a9f00000306a2004800');
  const set = Buffer.from(board.host.control(0xc0, 0x48, 0, 7, 500));
  assert.equal(set.length, 162);
  assert.equal(set.readUInt16LE(8), 162);
  assert.equal(set.toString('latin1', 14, 20), 'WINUSB');
  assert.equal(set.toString('utf16le', 38, 78), 'DeviceInterfaceGUIDs');
}));

for (const revision of [1, 2]) {
  test(`comes out of the bus’s reset behind a busy hub (chip revision ${revision}, erratum E5)`, withBoard((board, driver) => {
    board.host.busyHub = true;
    driver.enumerate();
    board.host.reset();
    driver.enumerate();
    assert.equal(board.mcu.gpio[15].functionSelect, 0x1f, 'pin 15 is free again');
    assert.ok(board.busiestCycles < 50_000);
  }, { revision }));
}

test('stalls what it does not know, and answers the next request', withBoard((board, driver) => {
  driver.enumerate();
  for (const [type, request, value, index, length] of [
    [0x80, 6, 0x0600, 0, 10], [0x80, 6, 0x0304, 0x409, 255], [0xc0, 0x48, 0, 4, 64], [0x40, 1, 0, 0, 0], [0x01, 11, 1, 0, 0], [0x02, 3, 0, 2, 0],
  ]) {
    assert.equal(board.host.control(type, request, value, index, length), 'stall');
    assert.equal(board.host.descriptor(1).length, 18);
  }
  assert.equal(hex(board.host.control(0x80, 0, 0, 0, 2)), '0100', 'a supply of its own');
  assert.equal(hex(board.host.control(0x80, 8, 0, 0, 1)), '01');
  assert.equal(hex(board.host.control(0x81, 0, 0, 0, 2)), '0000', 'status of the interface');
  assert.equal(hex(board.host.control(0x81, 10, 0, 0, 1)), '00', 'its setting');
  assert.equal(hex(board.host.control(0x82, 0, 0, 0, 2)), '0000', 'status of endpoint 0');
  // Its endpoints restart.
  assert.equal(hex(board.host.control(0x01, 11, 0, 0, 0)), '');
  board.host.toggle.set(1, 0).set(0x81, 0);
  const { sequence } = driver.last;
  board.run(5);
  assert.ok(driver.last.sequence > sequence);
}));

test('a halted endpoint is cleared by the host and goes on with DATA0', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  for (const endpoint of [0x01, 0x81]) {
    assert.equal(hex(board.host.control(2, 3, 0, endpoint)), '');
    assert.equal(hex(board.host.control(0x82, 0, 0, endpoint, 2)), '0100');
    const stalls = board.host.counts.stall;
    board.run(3);
    assert.ok(board.host.counts.stall > stalls);
    assert.notEqual(board.host.clearHalt(endpoint), 'stall');
    board.host.outQueue.length = 0;
    const { setPoint } = driver.last;
    board.run(5);
    assert.ok(driver.last.setPoint > setPoint);
  }
  assertDriving(board, driver);
}));

test('a reset of the bus ends the set-points: the dead-man stops it, and it comes back', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.host.reset();
  board.run(120);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  driver.enumerate();
  assert.equal(driver.last.mode, kMode.latched);
  assert.ok(driver.last.faults & kFault.deadMan);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

test('a suspended bus is the dead-man’s, and the board wakes with it', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.host.frames = false;
  board.run(110);
  assert.ok(board.host.suspended);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  board.host.frames = true;
  driver.last = undefined;
  board.run(5);
  assert.equal(driver.last.mode, kMode.latched);
}));

test('a pulled cable stops it within the dead-man’s time, and takes the pull-up away', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.host.plug(false);
  board.run(2);
  assert.equal(board.host.usb.sieCtrl & (1 << 16), 0);
  board.run(110);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  board.host.plug(true);
  driver.enumerate();
  assert.equal(driver.last.mode, kMode.latched);
}));

test('a host that does not read loses frames, not set-points', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.host.reading = false;
  board.run(150);
  assertDriving(board, driver);
  const { sequence } = driver.last;
  board.host.reading = true;
  board.run(3);
  assert.ok(driver.last.sequence > sequence + 100);
}));
