// SPDX-License-Identifier: MIT
// The image as a USB device.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertDriving, assertNoCurrent, kFiveAmps, withBoard } from './fixture.mjs';
import { readBoard } from '../../../firmware/board/netlist.mjs';
import { kFault, kMode, telemetry } from './frames.mjs';

/** Of the controller's registers: INTS, and its bit of a setup packet. */
const kUsbEvents = 0x98;
const kSetupEvent = 1 << 16;

const hex = (bytes) => Buffer.from(bytes).toString('hex');

test('sends the descriptors of daemon/device/board-protocol.md', withBoard((board, driver) => {
  const { device, configuration, strings } = driver.enumerate();
  assert.equal(hex(device), '120110020000004009120100020101020301');
  assert.equal(hex(configuration), '09022000010100804b0904000002ff4801000705010240000007058102400000');
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
  assert.equal(hex(board.host.control(0x80, 0, 0, 0, 2)), '0000', 'fed by the bus');
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

test('a packet that waits for the next frame is armed when none comes for 2 ms, before the bus is suspended', withBoard((board, driver) => {
  driver.enumerate();
  // Telemetry is due 0.85 ms after the start of a frame, where erratum E15 forbids it.
  const send = board.host.onFrame;
  board.host.onFrame = (host) => board.after(250, () => send(host));
  board.run(300);
  board.host.frames = false;
  const { frameUs } = board.host;
  const at = (us) => board.run((frameUs + us) / 1000 - board.chip.us / 1000);
  at(1700);
  assert.equal(board.host.armed(1), false);
  at(2950);
  assert.equal(board.host.armed(1), true);
  assert.equal(board.host.suspended, false);
}));

test('the bus’s power that it asks for is what the netlist’s parts draw, or more', withBoard((board, driver) => {
  const { configuration } = driver.enumerate();
  const reference = readBoard('reference');
  assert.equal(configuration[7], 0x80, 'no supply of its own');
  assert.equal(2 * configuration[8], reference.usbMa);
}));

test('what was sent before a suspend is too old after it: the first telemetry is that of the resume', withBoard((board, driver) => {
  driver.enumerate();
  board.run(20);
  board.host.reading = false;
  board.run(20); // one frame is armed and one waits
  board.host.reading = true;
  board.host.frames = false;
  board.run(300);
  assert.ok(board.host.suspended);
  board.host.frames = true;
  driver.last = undefined;
  const seen = [];
  board.host.onIn = (packet) => seen.push(telemetry(packet).sequence);
  board.run(10);
  assert.ok(seen.length >= 8);
  seen.slice(1).forEach((sequence, i) => assert.equal(sequence, seen[i] + 1, `${seen}`));
}));

test('what was completed just before a new configuration does not count for the buffers that it arms', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const { usb } = board.host;
  const read = usb.readUint32;
  let completed = 0;
  // Between the answer to the events and the answer to the request.
  usb.readUint32 = (offset) => {
    const value = read(offset);
    if (offset === kUsbEvents && value & kSetupEvent && completed === 0) {
      completed += board.host.out(1, Buffer.alloc(64, 0x48)) === 'ack' ? 1 : 0;
      completed += typeof board.host.in(1) === 'string' ? 0 : 1;
    }
    return value;
  };
  // The first after a frame of the bus: telemetry is armed.
  driver.sending = false;
  board.host.reading = false;
  board.run(2);
  board.host.configure();
  assert.equal(completed, 2);
  driver.sending = true;
  board.host.reading = true;
  const { refused } = driver.last;
  board.run(20);
  assert.equal(driver.last.refused, refused, 'the packet of before');
  assertDriving(board, driver);
}));

test('VBUS that is lost while the processor runs on ends the set-points, and takes the pull-up away', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  board.host.plug(false);
  board.run(22);
  assert.equal(board.host.usb.sieCtrl & (1 << 16), 0);
  board.run(90);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  board.host.plug(true);
  driver.enumerate();
  assert.equal(driver.last.mode, kMode.latched);
}));

test('a contact of VBUS that bounces does not end the connection', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  for (let i = 0; i < 4; ++i) {
    board.mcu.gpio[24].setInputValue(false);
    board.run(10);
    board.mcu.gpio[24].setInputValue(true);
    board.run(5);
  }
  board.run(150);
  assertDriving(board, driver);
  assert.equal(board.events.filter(({ awake }) => !awake).length, 0);
}));

test('a pulled cable takes the processor’s supply: asleep by the resistors at once, no current, and none when it is plugged in', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const { us } = board.chip;
  board.host.plug(false);
  board.chip.setPowered(false);
  board.run(0.01);
  const { awake, closed, pwm, direction } = board.pins();
  assert.deepEqual({ awake, closed, pwm, direction }, { awake: false, closed: false, pwm: [0, 0, 0], direction: 0 });
  board.run(19, () => board.trueMa < 100);
  console.log(`cable pulled: no current after ${((board.chip.us - us) / 1000).toFixed(1)} ms`);
  assert.ok(board.trueMa < 100, `${board.trueMa} mA`);
  board.run(300);
  assertNoCurrent(board);
  board.host.plug(true);
  board.chip.setPowered(true);
  board.run(10);
  driver.enumerate();
  board.run(50);
  assert.equal(driver.last.mode, kMode.safe);
  assertNoCurrent(board);
  assert.equal(board.chip.resets, 0);
}));

const kHungMs = 2000;

/** A controller that hangs (erratum E15): no packet is answered, no event is seen, until its reset. */
function hang(board) {
  const { host } = board;
  const own = { frame: host.frame, bulk: host.bulk, listens: host.listens };
  Object.assign(host, { frame() {}, bulk() {}, listens: () => false });
  let restarted;
  board.chip.onUsbReset = () => {
    Object.assign(host, own);
    host.resetBus();
    restarted = board.chip.us;
  };
  const begun = board.chip.us;
  return () => (restarted === undefined ? undefined : (restarted - begun) / 1000);
}

test('a USB controller that hangs is reset 2 s later, asleep since the dead-man, and enumerated again', withBoard((board, driver) => {
  driver.drive(kFiveAmps);
  const restartedMs = hang(board);
  board.run(110);
  assert.equal(board.pins().awake, false);
  assertNoCurrent(board);
  board.run(kHungMs + 200, () => restartedMs() !== undefined);
  console.log(`USB controller hangs: reset after ${restartedMs()} ms`);
  // From the end of the last driven millisecond on.
  assert.ok(restartedMs() > kHungMs && restartedMs() < kHungMs + 110, `${restartedMs()} ms`);
  assert.equal(board.host.usb.sieCtrl & (1 << 16), 0, 'the host sees it leave');
  driver.enumerate();
  assert.equal(board.chip.resets, 0);
  assert.equal(driver.last.mode, kMode.latched);
  assert.ok(driver.last.faults & kFault.deadMan);
  assertNoCurrent(board);
  driver.arm();
  board.run(60);
  assertDriving(board, driver);
}));

test('a host that suspends the board for longer than that does not see it leave', withBoard((board, driver) => {
  driver.enumerate();
  board.chip.onUsbReset = () => assert.fail('a reset of the controller');
  board.host.frames = false;
  board.run(kHungMs + 500);
  board.host.frames = true;
  driver.last = undefined;
  board.run(5);
  assert.equal(driver.last.mode, kMode.safe);
}));

test('nor does a host that only sends frames of the bus', withBoard((board, driver) => {
  driver.enumerate();
  board.chip.onUsbReset = () => assert.fail('a reset of the controller');
  driver.sending = false;
  board.host.reading = false;
  board.run(kHungMs + 500);
  board.host.reading = true;
  board.run(5);
  assert.equal(driver.last.mode, kMode.safe);
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
