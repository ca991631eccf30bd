// SPDX-License-Identifier: MIT
// Compares the readings in firmware/board/bring-up.md with the netlist of the reference board.
import assert from "node:assert/strict";
import { test } from "node:test";

import { circuitAt, ntcOhm } from "../../firmware/board/circuits.mjs";
import { asBuilt, kTypes, prose, sourceText } from "./boards.mjs";

const reference = asBuilt("reference");
const thesis = asBuilt("thesis");
const guide = sourceText("firmware/board/bring-up.md");
const sentences = prose(guide);
const variantB = sentences.slice(sentences.indexOf("## Variant B"));
const resistor = (ref) => reference.parts.get(ref);

/** The numbers of the first match of `pattern` in `text`. */
function printed(pattern, text = guide) {
  const match = pattern.exec(text);
  assert.ok(match, `${pattern} is not in the guide`);
  return match.slice(1).map(Number);
}
/** The guide's range contains every value that parts within their tolerances give, and is within 20 % of the nominal value. */
function within(value, share, [low, high]) {
  assert.ok(low <= value * (1 - share) && high >= value * (1 + share), `${value} +- ${100 * share} % is not in ${low}..${high}`);
  assert.ok(low > 0.8 * value && high < 1.2 * value, `${low}..${high} is far from ${value}`);
}

test("SLP to ground reads its resistor, 12V to ground the divider of the supply", () => {
  const [low, high] = printed(/SLP and GND \| (\d+)–(\d+) Ω/);
  within(resistor("R6").value, resistor("R6").tol, [low, high]);
  const { upper, lower } = circuitAt(reference, kTypes, "U7.CH4");
  const [kiloohm, percent] = printed(/12V and GND \| (\d+) kΩ ± (\d+) %/);
  within(upper.value + lower.value, upper.tol, [1e3 * kiloohm * (1 - percent / 100), 1e3 * kiloohm * (1 + percent / 100)]);
});

test("PWM and SWITCH to ground read their resistors beside the pull-downs of what they drive", () => {
  for (const [pattern, ref, type, pin] of [[/each PWM and GND \| ([\d.]+)–([\d.]+) kΩ/, "R7", "G2_18V17", "PWM"], [/SWITCH and GND \| ([\d.]+)–([\d.]+) kΩ/, "R2", "BTS50010", "IN"]]) {
    const { min, max } = kTypes.get(type).pins.get(pin).pull;
    const { value, tol } = resistor(ref);
    const parallel = (a, b) => (a * b) / (a + b);
    const [low, high] = printed(pattern).map((kiloohm) => 1e3 * kiloohm);
    assert.ok(low < parallel(value * (1 - tol), min) && high > parallel(value * (1 + tol), max), `${low}..${high}`);
    assert.ok(low > 0.9 * parallel(value * (1 - tol), min) && high < 1.1 * parallel(value * (1 + tol), max), `${low}..${high}`);
  }
});

test("VREF is set for chopping at 18 A, CS shows its zero", () => {
  const driver = kTypes.get("G2_18V17");
  const [vref, amps] = printed(/each VREF \| .* ([\d.]+) ± [\d.]+ V: chopping at (\d+) A/);
  assert.ok(Math.abs(vref - driver.sense_zero_v - amps * driver.sense_v_per_a) < 0.001, `${vref} V`);
  assert.deepEqual(printed(/each CS \| about ([\d.]+) V/), [driver.sense_zero_v]);
});

test("V_SUP at 12 V is what the divider gives", () => {
  const { upper, lower } = circuitAt(reference, kTypes, "U7.CH4");
  const [volts] = printed(/V_SUP \| (1[\d.]+) V at 12\.0 V/);
  assert.ok(Math.abs(volts - 12 * lower.value / (upper.value + lower.value)) < 0.005);
});

test("the amplifiers' zeros are half of their supply, within what the firmware takes", () => {
  const { zero, amp } = circuitAt(reference, kTypes, "U7.CH0");
  const [low, high] = printed(/\(OUT of U2–U4\) \| ([\d.]+)–([\d.]+) V/);
  within(3.3 * zero / reference.nets.get(amp.pins.get("VS")).min, 0.002, [low, high]);
  assert.ok(Math.abs(high - low - 0.016) < 1e-9, "8 mV each way, as in pico_wiring.h");
});

test("5 A raise the outputs by what shunt and amplifier give", () => {
  const [millivolts, percent] = printed(/IVM rises to (\d+) mV ± (\d+) %/, sentences);
  within(5e3 * circuitAt(reference, kTypes, "U7.CH3").voltsPerUnit, 0.012, [millivolts * (1 - percent / 100), millivolts * (1 + percent / 100)]);
});

test("the figures of the windings are reckoned with the design's scale, and expected where the firmware takes them", () => {
  const { voltsPerUnit } = circuitAt(reference, kTypes, "U7.CH0");
  const wiring = sourceText("firmware/pico_wiring.h");
  const limit = (name) => Number(new RegExp(`${name} = ([\\d']+);`).exec(wiring)[1].replaceAll("'", ""));
  const [zero, scale, deviation] = [/`kCurrentZeroUv` \| ([\d ]+) \+ ([\d ]+) × .*± ([\d ]+) of 1 650 000/]
    .flatMap((pattern) => pattern.exec(guide).slice(1)).map((text) => Number(text.replaceAll(" ", "")));
  assert.deepEqual([zero, scale, deviation], [1.65e6, 1e6 * voltsPerUnit, limit("kMaxZeroDeviationUv")]);
  const [, perA, percent] = /`kCurrentUvPerA` \| ([\d ]+) × \(plus − minus\) \/ 10\.00.*within (\d) %/.exec(guide);
  assert.deepEqual([Number(perA.replaceAll(" ", "")), Number(percent)], [scale, limit("kMaxScaleDeviationPercent")]);
});

test("each direction of step 7 drives the winding at the connector beside it", () => {
  const device = sourceText("config/devices.d/hedgehog-86.json");
  assert.match(device, /"coil_matrix": \[\[1, 0, 0\], \[0, 1, 0\], \[0, 0, 1\]\]/);
  assert.match(device, /towards the front, the left and the top/);
  ["front", "left", "up"].forEach((direction, k) => {
    const [, letter, axis, connector] = new RegExp(`\\| \`${direction}\`, .*? \\| ([ABC]) \\(([xyz])\\) \\| (J\\d) \\|`).exec(guide);
    assert.equal(axis, "xyz"[k]);
    // From the pin of bridge k of the firmware to the connector.
    const pwm = reference.parts.get("U1").pins.get(`GP${Number(/kPwmPin = (\d);/.exec(sourceText("firmware/pins.h"))[1]) + k}`);
    assert.equal(pwm, `PWM_${letter}`);
    const driver = [...reference.parts.values()].find((part) => part.kind === "driver" && part.pins.get("PWM") === pwm);
    const shunt = [...reference.parts.values()].find((part) => part.kind === "shunt" && part.pins.get("1") === driver.pins.get("OUTA"));
    assert.equal(reference.parts.get(connector).pins.get("1"), shunt.pins.get("2"));
  });
  const step7 = prose(/\n## 7\. [^]*?(?=\n## )/.exec(guide)[0]);
  assert.match(step7, /Coil on J2 and nothing on J3 and J4/);
  assert.match(step7, /hedgehogctl hold front --current-a 0\.5/);
});

test("the supply's voltages in the warning are those of the clamp, the connector and the firmware", () => {
  const warning = printed(/\*\*Never more than (\d+) V at J1\.\*\* D1 conducts from (\d+) V on and a supply of 24 V burns it: about (\d+) A/, sentences);
  const tvs = kTypes.get("TVS");
  const amps = (24 - tvs.breakdown_v) * tvs.clamp_a / (tvs.clamp_v - tvs.breakdown_v);
  assert.deepEqual(warning, [kTypes.get("SUPPLY").pins.get("+").v.max, Number(/([\d.]+)\.\./.exec(tvs.source.replace("SMCJ series: ", ""))[1]), Math.round(amps)]);
  const port = sourceText("daemon/device/board_core/port.h");
  assert.equal(Number(/limits\.supply_max_mv = ([\d']+);/.exec(port)[1].replace("'", "")) / 1e3, tvs.standoff_v);
  assert.match(sentences, /closes Q1 only at 6\.5 to 18 V/);
});

test("the thermistors' voltages are those of their curve", () => {
  const { pullUp, ntc } = circuitAt(reference, kTypes, "U7.CH5");
  const readings = printed(/NTC_A \(B, C\) \| ([\d.]+) V at 15 °C, ([\d.]+) at 20, ([\d.]+) at 25, ([\d.]+) at 30/);
  [15, 20, 25, 30].forEach((celsius, i) => {
    const ohm = ntcOhm(ntc, celsius);
    assert.ok(Math.abs(readings[i] - 3.3 * ohm / (ohm + pullUp.value)) < 0.01, `${readings[i]} V at ${celsius} C`);
  });
});

/** "RS1–RS3, U2" as references. */
const expanded = (list) => list.split(", ").flatMap((one) => {
  const [, letters, from, to = from] = /^([A-Z]+)(\d+)(?:–[A-Z]+(\d+))?$/.exec(one);
  return Array.from({ length: to - from + 1 }, (_, i) => `${letters}${+from + i}`);
});

test("variant B is assembled without exactly the parts that its netlist does not have", () => {
  const missing = [...reference.parts.keys()].filter((ref) => !thesis.parts.has(ref));
  assert.ok(missing.length > 10);
  assert.deepEqual(expanded(/Left out: (.*?)\. /.exec(variantB)[1]).sort(), missing.sort());
});

test("variant B has at ground the inputs that the guide names, and its windings at the bridges", () => {
  const { pins } = thesis.parts.get("U7");
  const grounded = [...pins].filter(([name, net]) => name.startsWith("CH") && net === "GND").map(([name]) => name);
  const list = `${grounded.slice(0, -1).join(", ")} and ${grounded.at(-1)}`;
  assert.equal(variantB.split(`${list} of U7`).length - 1, 2, list);
  for (const [winding, driver] of [["J2", "M1"], ["J3", "M2"], ["J4", "M3"]])
    assert.equal(thesis.parts.get(winding).pins.get("1"), thesis.parts.get(driver).pins.get("OUTA"));
  assert.equal(thesis.parts.get("J5").pins.size, 2);
  assert.match(variantB, /J5 has two poles and one thermistor/);
});

test("CS reads what the driver's figures give, with nothing and with 2.2 ohm at the supply", () => {
  const { zero, voltsPerUnit } = circuitAt(thesis, kTypes, "U1.GP26");
  const [volts, amps, ohm] = [/CS_A reads ([\d.]+) V/, /V at ([\d.]+) A/, /Put ([\d.]+) Ω/].map((pattern) => Number(pattern.exec(variantB)[1]));
  assert.ok(Math.abs(amps - 12 / ohm) < 0.01);
  assert.ok(Math.abs(volts - (zero + voltsPerUnit * amps)) < 0.001);
  assert.equal(Number(/ADC_C \| about ([\d.]+) V/.exec(variantB)[1]), zero);
});

test("what the daemon allows with variant B is the thermal model's result", () => {
  const results = sourceText("model/thermal-model.md");
  const [, full] = /15 A along a coil from cold \| full for ([\d.]+) s/.exec(results);
  const [, cs] = /15 A along a coil from cold .*`driver_cs`: ([\d.]+) s/.exec(results);
  assert.ok(variantB.includes(`15 A from cold last ${cs} s instead of ${full} s`));
  assert.match(results, /`driver_cs`: 67 °C after seven hours, then a little less than 5 A/);
  assert.match(variantB, /5 A in a room of 25 °C are reduced a little after seven hours/);
});

test("the guide says that no image drives variant B, as long as none does", () => {
  const reads = ["firmware/pico_wiring.h", "firmware/converter.cpp"].some((path) => /kDriverCs|kAdc/.test(sourceText(path)));
  assert.equal(/No image here drives variant B/.test(variantB), !reads);
});
