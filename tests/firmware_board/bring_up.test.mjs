// SPDX-License-Identifier: MIT
// Compares the readings in firmware/board/bring-up.md with the netlist of the reference board.
import assert from "node:assert/strict";
import { test } from "node:test";

import { circuitAt, ntcOhm } from "../../firmware/board/circuits.mjs";
import { asBuilt, kTypes, sourceText } from "./boards.mjs";

const reference = asBuilt("reference");
const guide = sourceText("firmware/board/bring-up.md");
const resistor = (ref) => reference.parts.get(ref);

/** The numbers of the first match of `pattern` in the guide. */
function told(pattern) {
  const match = pattern.exec(guide);
  assert.ok(match, `${pattern} is not in the guide`);
  return match.slice(1).map(Number);
}
/** The guide's range contains every value that parts within their tolerances give, and is within 20 % of the nominal value. */
function within(value, share, [low, high]) {
  assert.ok(low <= value * (1 - share) && high >= value * (1 + share), `${value} +- ${100 * share} % is not in ${low}..${high}`);
  assert.ok(low > 0.8 * value && high < 1.2 * value, `${low}..${high} is far from ${value}`);
}

test("SLP to ground reads its resistor, 12V to ground the divider of the supply", () => {
  const [low, high] = told(/SLP and GND \| (\d+)–(\d+) Ω/);
  within(resistor("R6").value, resistor("R6").tol, [low, high]);
  const { upper, lower } = circuitAt(reference, kTypes, "U7.CH4");
  const [kiloohm, percent] = told(/12V and GND \| (\d+) kΩ ± (\d+) %/);
  within(upper.value + lower.value, upper.tol, [1e3 * kiloohm * (1 - percent / 100), 1e3 * kiloohm * (1 + percent / 100)]);
});

test("V_SUP at 12 V is what the divider gives", () => {
  const { upper, lower } = circuitAt(reference, kTypes, "U7.CH4");
  const [volts] = told(/V_SUP \| (1[\d.]+) V at 12\.0 V/);
  assert.ok(Math.abs(volts - 12 * lower.value / (upper.value + lower.value)) < 0.005);
});

test("the amplifiers' zeros are half of their supply, within what the firmware takes", () => {
  const { zero, amp } = circuitAt(reference, kTypes, "U7.CH0");
  const [low, high] = told(/\(OUT of U2–U4\) \| ([\d.]+)–([\d.]+) V/);
  within(3.3 * zero / reference.nets.get(amp.pins.get("VS")).min, 0.002, [low, high]);
  assert.ok(Math.abs(high - low - 0.016) < 1e-9, "8 mV each way, as in pico_wiring.h");
});

test("5 A raise the outputs by what shunt and amplifier give", () => {
  for (const [at, pattern] of [["U7.CH0", /IA rises by (\d+) mV ± (\d+) %/], ["U7.CH3", /IVM rises to (\d+) mV ± (\d+) %/]]) {
    const [millivolts, percent] = told(pattern);
    within(5e3 * circuitAt(reference, kTypes, at).voltsPerUnit, 0.012, [millivolts * (1 - percent / 100), millivolts * (1 + percent / 100)]);
  }
});

test("the thermistors' voltages are those of their curve", () => {
  const { pullUp, ntc } = circuitAt(reference, kTypes, "U7.CH5");
  const readings = told(/NTC_A \(B, C\) \| ([\d.]+) V at 15 °C, ([\d.]+) at 20, ([\d.]+) at 25, ([\d.]+) at 30/);
  [15, 20, 25, 30].forEach((celsius, i) => {
    const ohm = ntcOhm(ntc, celsius);
    assert.ok(Math.abs(readings[i] - 3.3 * ohm / (ohm + pullUp.value)) < 0.01, `${readings[i]} V at ${celsius} C`);
  });
});
