// SPDX-License-Identifier: MIT
// The pin configuration of the image, against the netlist of the reference board.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pinsOn, readBoard, readParts, resistorsOn } from '../../../firmware/board/netlist.mjs';
import { driveMa } from '../../../firmware/board/rules_budget.mjs';
import { withBoard } from './fixture.mjs';

const types = readParts();
const reference = readBoard('reference');
const pico = reference.parts.get('U1');
/** RP2040 data sheet 2.19.6.3 and 5.2.3.4. */
const kDriveMa = [2, 4, 8, 12];
const kMinHighV = 2.62;
const kMaxLowV = 0.5;
const kNoFunction = 0x1f;

/** {name, number, net, gpio} of each GPIO that the netlist connects. */
const connected = (board) => [...pico.pins].filter(([name, net]) => /^GP\d+$/.test(name) && net).map(([name, net]) => {
  const number = Number(name.slice(2));
  return { name, number, net, gpio: board.mcu.gpio[number] };
});
/** SPI has one line that the converter drives. */
const drives = ({ net, gpio }) => gpio.outputEnable || gpio.functionSelect === 4 || (gpio.functionSelect === 1 && net !== 'SPI_OUT');

test('each output has the drive that the netlist asks for, and reaches the levels of what it drives', withBoard((board, driver) => {
  driver.enumerate();
  const outputs = connected(board).filter(drives);
  assert.deepEqual(outputs.map(({ net }) => net).sort(), [
    'DIR_A', 'DIR_B', 'DIR_C', 'FAN_CTL', 'PWM_A', 'PWM_B', 'PWM_C', 'SLP', 'SPI_CLK', 'SPI_CS', 'SPI_IN', 'SWITCH',
  ]);
  for (const { name, net, gpio } of outputs) {
    assert.equal(kDriveMa[gpio.padValue >> 4 & 3], driveMa(reference, pico, name), `drive of ${name} (${net})`);
    const inputs = pinsOn(reference, types, net).filter(({ kind }) => kind === 'in');
    assert.notDeepEqual(inputs, [], `${net} drives nothing`);
    for (const input of inputs) {
      assert.ok(input.vih <= kMinHighV && input.vil >= kMaxLowV, `${input.part.ref}.${input.name} on ${net}`);
    }
  }
}));

test('a pull inside the chip never works against a resistor of the board', withBoard((board, driver) => {
  driver.enumerate();
  const checked = [];
  for (const { name, net, gpio } of connected(board)) {
    if (gpio.functionSelect === kNoFunction) continue; // as in reset, which the electrical rules check
    for (const { other } of resistorsOn(reference, net)) {
      if (other === 'GND' || other === '3V3') checked.push(net);
      assert.ok(!(other === 'GND' && gpio.pullupEnabled), `${name} (${net}) pulls up`);
      assert.ok(!(other === '3V3' && gpio.pulldownEnabled), `${name} (${net}) pulls down`);
    }
  }
  assert.deepEqual(checked.sort(), [
    'FAN_CTL', 'FLT_A', 'FLT_B', 'FLT_C', 'PWM_A', 'PWM_B', 'PWM_C', 'SLP', 'SPI_CS', 'SWITCH', 'TACH',
  ]);
}));
