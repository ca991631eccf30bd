// SPDX-License-Identifier: MIT
// The boards agree with the rest of the project: the constants of the firmware, the errors of the simulator, and the files
// that are generated from the netlists.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { generated } from "../../firmware/board/board.mjs";
import { circuitAt } from "../../firmware/board/circuits.mjs";
import { errorBudget } from "../../firmware/board/error_budget.mjs";
import { safeWays } from "../../firmware/board/figures.mjs";
import { sleep } from "../../firmware/board/flyback.mjs";
import { kBoardFolder } from "../../firmware/board/netlist.mjs";
import { asBuilt, kTypes, prose, sourceText } from "./boards.mjs";

const reference = asBuilt("reference");
const thesis = asBuilt("thesis");

/** The number that `pattern` captures in a source; digits may have separators. */
function constant(path, pattern) {
  const match = pattern.exec(sourceText(path));
  assert.ok(match, `${path}: ${pattern}`);
  return Number(match[1].replaceAll("'", ""));
}
const port = (pattern) => constant("daemon/device/board_core/port.h", pattern);
const frontEnd = (pattern) => constant("daemon/device/simulator/front_end.cpp", pattern);
const close = (actual, expected) => assert.ok(Math.abs(actual - expected) <= 1e-6 * Math.abs(expected), `${actual} is not ${expected}`);

test("the constants of the firmware are those of the reference board", () => {
  for (const at of ["U7.CH0", "U7.CH1", "U7.CH2"]) {
    const { voltsPerUnit, zero, amp } = circuitAt(reference, kTypes, at);
    close(1e6 * voltsPerUnit, port(/current_uv_per_a\[k\] = ([\d']+);/));
    assert.equal(Math.round(1e3 * zero / reference.nets.get(amp.pins.get("VS")).min * 3.3), port(/current_zero_uv\[k\] = ([\d']+);/) / 1e3);
  }
  close(1e6 * circuitAt(reference, kTypes, "U7.CH3").voltsPerUnit, port(/shunt_uv_per_a = ([\d']{5,});/));
  for (const at of ["U7.CH5", "U7.CH6", "U7.CH7"])
    close(circuitAt(reference, kTypes, at).pullUp.value, port(/ntc_pull_up_ohm = ([\d']+);/));
  assert.equal(port(/wiring\.thermistors = (\d);/), 3);
});

test("divider, converter and CS of the firmware are those of both boards", () => {
  for (const board of [reference, thesis]) {
    const { upper, lower } = circuitAt(board, kTypes, "U7.CH4");
    close(upper.value, port(/supply_upper_ohm = ([\d']+);/));
    close(lower.value, port(/supply_lower_ohm = ([\d']+);/));
    close(1e3 * kTypes.get("REF3033").output_v, port(/adc_reference_mv = ([\d']+);/));
    close(1e6 * circuitAt(board, kTypes, "U1.GP26").voltsPerUnit, port(/uint32_t current_uv_per_a\[kWindings\] = \{([\d']+),/));
    close(1e6 * circuitAt(board, kTypes, "U1.GP26").zero, port(/current_zero_uv\[kWindings\] = \{([\d']+),/));
  }
});

test("the firmware accepts each calibration within the tolerances of the parts", () => {
  const limit = (name) => constant("firmware/pico_wiring.h", new RegExp(`${name} = ([\\d']+);`));
  // The deviations that are in what is read, all at their limits: of the windings by telemetry, of the supply by a meter.
  const seen = (name, kinds) => errorBudget(reference, kTypes).find((one) => one.name === name).list
    .filter(([kind]) => kinds.includes(kind)).reduce((sum, [, value]) => sum + value, 0);
  const { voltsPerUnit } = circuitAt(reference, kTypes, "U7.CH0");
  const kZero = ["amplifier", "divider of the zero", "converter, zero", "converter, gain at the zero"];
  const zeroUv = 1e6 * voltsPerUnit * seen("current_a zero", kZero);
  assert.ok(zeroUv > 1000 && zeroUv < limit("kMaxZeroDeviationUv"), `${zeroUv} uV`);
  for (const [name, kinds] of [["current_a gain", ["shunt", "amplifier", "reference", "converter, gain"]], ["supply_a gain", ["shunt", "amplifier"]]]) {
    const percent = 100 * (seen(name, kinds) + seen(`${name}, calibrated`, ["ammeter", "voltmeter, two ranges", "converter, linearity at 5 A each way"]));
    assert.ok(percent > 1 && percent < limit("kMaxScaleDeviationPercent"), `${percent} %`);
  }
});

test("what the guide measures is in the budget: the windings through the converter, with its errors, the supply by a meter, without them", () => {
  const list = (name) => errorBudget(reference, kTypes).find((one) => one.name === name).list.map(([kind]) => kind);
  const guide = sourceText("firmware/board/bring-up.md");
  const byTelemetry = /hedgehogctl telemetry --fields current_a --rate-hz \d+ --count (\d+)/.exec(guide);
  assert.ok(byTelemetry, "the guide reads the currents by telemetry");
  assert.equal(Number(byTelemetry[1]), constant("firmware/board/error_budget.mjs", /kReadings = (\d+);/));
  assert.ok(!list("current_a zero, calibrated").some((kind) => /zero|divider/.test(kind)));
  // Its zero is not measured: a calibrated one would have to be entered.
  assert.ok(list("supply_a gain, calibrated").includes("converter, gain"));
  assert.ok(!errorBudget(reference, kTypes).some(({ name }) => name === "supply_a zero, calibrated"));
  assert.doesNotMatch(sourceText("firmware/calibration.h"), /kShuntZero/);
});

test("the ripple is a bias, as conversions and PWM have one clock, 20 periods a millisecond, and a small one at the sampling points", () => {
  const periods = 125e6 / constant("firmware/pico_wiring.h", /kPwmPeriod = (\d+);/) * constant("firmware/tick.h", /kPeriodUs = (\d+);/) * 1e-6;
  const noise = errorBudget(reference, kTypes).find(({ name }) => name === "current_a noise");
  assert.equal(Number.isInteger(periods), !noise.list.some(([kind]) => /ripple/.test(kind)), `${periods} periods`);
  const bias = errorBudget(reference, kTypes).find(({ name }) => name === "current_a bias while driven");
  // The slope of the ripple at half duty, 0.10 A in 25 us, for the microsecond of the drivers' delay.
  assert.ok(Math.abs(bias.worst - 0.1 / 25) < 1e-9, `${bias.worst} A`);
  // The simulator has none: its gain has to be worse by so much.
  const [gain, share] = ["current_a gain, calibrated", "current_a bias while driven, of the current"]
    .map((name) => errorBudget(reference, kTypes).find((one) => one.name === name).combined);
  assert.ok(gain + share < frontEnd(/kGain = ([\d.]+);/), `${gain} + ${share}`);
});

/** [quantity, the simulator's figure, its minimum as a share of the error budget]. */
const kLimits = [
  ["current_a gain", /kGain = ([\d.]+);/, 1], ["current_a zero, calibrated", /kInLineOffsetA = ([\d.]+);/, 1],
  ["current_a noise", /in_line \? ([\d.]+) : 0\.10;/, 1], ["supply_a gain", /kGain = ([\d.]+);/, 1],
  // Uncalibrated; below the floor of 0.1 A it does not matter.
  ["supply_a zero", /kShuntOffsetA = ([\d.]+);/, 0.8], ["supply_a noise", /shunt_noise_a = ([\d.]+);/, 1],
  ["supply_v gain", /kGain = ([\d.]+);/, 1], ["supply_v noise", /supply_noise_v = ([\d.]+);/, 1],
  ["ntc_a at 75 C", /kThermistorK = ([\d.]+);/, 1],
  // The microcontroller's own converter is worse than the simulated one, by its linearity: figures.md.
  ["cs_a gain, calibrated", /kGain = ([\d.]+);/, 0.8], ["cs_a zero, calibrated", /kDriverCsOffsetA = ([\d.]+);/, 1],
  ["cs_a noise", /0\.04 : ([\d.]+);/, 0.8],
];

for (const [name, pattern, share] of kLimits)
  test(`the simulator is no better than the board: ${name}`, () => {
    const board = name.startsWith("cs") ? thesis : reference;
    const found = errorBudget(board, kTypes).find((one) => one.name === name);
    const simulated = frontEnd(pattern);
    assert.ok(simulated >= share * found.combined, `${simulated} < ${share} * ${found.combined}`);
    // Nor so much worse that tests with the simulator do not apply to this board. It has the bias as noise.
    const bias = errorBudget(board, kTypes).find((one) => one.name === name.replace(/noise$/, "bias while driven"))?.combined ?? 0;
    const all = name.endsWith("noise") ? found.combined + bias : found.combined;
    assert.ok(simulated <= 5 * all, `${simulated} > 5 * ${all}`);
  });

test("zero must be calibrated: out of the box it may be off by more than the simulator has it", () => {
  const found = errorBudget(reference, kTypes).find(({ name }) => name === "current_a zero");
  assert.ok(found.combined > frontEnd(/kInLineOffsetA = ([\d.]+);/));
});

test("what sleeping bridges draw, as the supply's amplifier shows it, is below the threshold of a stuck bridge", () => {
  const budget = errorBudget(reference, kTypes);
  const floor = budget.find(({ name }) => name === "supply_a floor").worst;
  const zero = budget.find(({ name }) => name === "supply_a zero").worst;
  const stuckA = constant("daemon/device/board_core/limits.h", /kStuckSupplyMa = (\d+);/) / 1e3;
  const drivers = [...reference.parts.values()].filter(({ type }) => type === "G2_18V17").length;
  assert.equal(drivers, 3);
  const idleA = drivers * kTypes.get("G2_18V17").pins.get("VIN").draws_ma / 1e3 + reference.nets.get("VM").max / reference.parts.get("R32").value;
  assert.ok(Math.max(floor, idleA + zero) + 3 * budget.find(({ name }) => name === "supply_a noise").combined < stuckA);
});

test("the capacitors behind the supply switch charge before their current counts as a stuck bridge, at each limit of the guide", () => {
  const behind = [...reference.parts.values()].filter(({ type, pins }) => type === "C" && [...pins.values()].includes("VM"));
  assert.equal(behind.length, 3);
  const farad = behind.reduce((sum, { value, tol }) => sum + value * (1 + tol), 0);
  const fanA = kTypes.get("FAN").pins.get("12V").draws_ma / 1e3;
  const { max: volts } = reference.nets.get("12V");
  const limits = [...prose(sourceText("firmware/board/bring-up.md")).matchAll(/12 V with limit (\d+(?:\.\d+)?) A/g)].map(([, amps]) => Number(amps));
  assert.ok(limits.length >= 2, "steps 5 and 7");
  const chargingMs = constant("daemon/device/board_core/limits.h", /kChargingMs = (\d+);/);
  for (const amps of limits) {
    const ms = 1e3 * farad * volts / (amps - fanA);
    assert.ok(ms > 0 && ms < chargingMs, `${ms.toFixed(0)} ms at ${amps} A`);
  }
});

test("a winding's energy is in the capacitors, in its resistance, in the diodes or in the clamp, and nowhere else", () => {
  const winding = { henry: 1.5e-3, ohm: 0.45 };
  const [farad, startV, amps] = [2.4e-3, 13.2, 16.5];
  const { peakV, returnedJ, clampJ } = sleep(winding, [amps], farad, startV, null);
  assert.equal(clampJ, 0);
  const capacitorsJ = farad * (peakV * peakV - startV * startV) / 2;
  assert.ok(Math.abs(capacitorsJ - returnedJ) < 0.01 * returnedJ, `${capacitorsJ} J, ${returnedJ} J`);
  assert.ok(returnedJ < winding.henry * amps * amps / 2);
});

test("the board stands bridges that fall asleep at full current; nothing needs them to brake before", () => {
  const ways = safeWays(reference, kTypes);
  assert.ok(Math.abs(ways.storedJ - 0.204) < 0.001);
  for (const { peakV, limitV, clampJ, energyJ } of ways.cases) {
    assert.ok(peakV < limitV);
    assert.ok(clampJ < energyJ / 5);
  }
  // With the bridges asleep the current decays in less than a tenth of the braking time.
  assert.ok(ways.cases[0].seconds < ways.brakeS / 10);
});

test("the limits of the board are those calculated", () => {
  const core = (pattern) => constant("daemon/device/board_core/limits.h", pattern);
  assert.equal(reference.winding.amps, core(/current_ma = (\d+);/) / 1e3);
  assert.ok(kTypes.get("G2_18V17").practical_v < core(/supply_max_mv = (\d+);/) / 1e3);
  close(reference.winding.henry, constant("model/thermal/plant.h", /inductance_h = ([\d.e-]+);/));
  close(reference.winding.ohm, constant("model/thermal/plant.h", /r25_ohm\{([\d.]+),/));
});

for (const board of [reference, thesis])
  test(`the diagram of the board ${board.name} has every part and every net`, () => {
    const words = new Set(generated()[`wiring-${board.name}.svg`].replace(/<[^>]*>/g, " ").split(/[\s.]+/));
    const rows = generated()[`bom-${board.name}.csv`].split(/[\s,]+/);
    for (const ref of board.parts.keys()) {
      assert.ok(words.has(ref), `${ref} is not in the diagram`);
      assert.ok(rows.includes(ref), `${ref} is not in the bill of materials`);
    }
    for (const net of board.nets.keys()) assert.ok(words.has(net), `${net} is not in the diagram`);
  });

/** Approximate width of a text of size 1. */
const letterWidth = (letter) => (/[ ,.'·:]/.test(letter) ? 0.32 : /[A-Z0-9_]/.test(letter) ? 0.6 : 0.55);
const widthOf = (text, bold) => (bold ? 1.12 : 1) * [...text].reduce((sum, letter) => sum + letterWidth(letter), 0);

/** The boxes of the texts of a diagram: {text, left, right, top, bottom}. */
function textBoxes(svg) {
  return [...svg.matchAll(/<text x="([-\d.]+)" y="([-\d.]+)" font-size="([\d.]+)" text-anchor="(\w+)"([^>]*)>(.*?)<\/text>/g)].map(([, x, y, size, anchor, more, inner]) => {
    const text = inner.replace(/<[^>]*>/g, "");
    const width = size * widthOf(text, more.includes("bold"));
    const left = x - { start: 0, middle: width / 2, end: width }[anchor];
    return { text, left, right: left + width, top: y - 0.7 * size, bottom: +y };
  });
}

for (const board of [reference, thesis])
  test(`no text of the diagram of the board ${board.name} hides another or leaves the page`, () => {
    const boxes = textBoxes(generated()[`wiring-${board.name}.svg`]);
    assert.ok(boxes.length > 150);
    for (const [i, a] of boxes.entries()) {
      assert.ok(a.left >= 0 && a.right <= 1188 && a.top >= 0 && a.bottom <= 840, `${a.text} leaves the page`);
      for (const b of boxes.slice(i + 1))
        assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${a.text} and ${b.text}`);
    }
  });

/** Lines of a diagram and edges of its boxes: {left, right, top, bottom}. The first box is the page. */
function strokes(svg) {
  const of = (points) => points.slice(1).map(([x, y], i) => ({
    left: Math.min(x, points[i][0]), right: Math.max(x, points[i][0]), top: Math.min(y, points[i][1]), bottom: Math.max(y, points[i][1]),
  }));
  const lines = [...svg.matchAll(/<polyline points="([^"]*)"/g)].map(([, points]) => points.split(" ").map((point) => point.split(",").map(Number)));
  const boxes = [...svg.matchAll(/<rect x="([-\d.]+)" y="([-\d.]+)" width="([\d.]+)" height="([\d.]+)"/g)].map((match) => {
    const [x, y, width, height] = match.slice(1).map(Number);
    return [[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]];
  });
  return [...lines, ...boxes].flatMap(of);
}

for (const board of [reference, thesis])
  test(`no line crosses a text of the diagram of the board ${board.name}`, () => {
    const svg = generated()[`wiring-${board.name}.svg`];
    const all = strokes(svg);
    assert.ok(all.length > 150, `${all.length}`);
    for (const text of textBoxes(svg))
      for (const one of all)
        assert.ok(text.right <= one.left || one.right <= text.left || text.bottom <= one.top || one.bottom <= text.top,
          `${text.text} at ${text.left}, ${text.bottom}: ${JSON.stringify(one)}`);
  });

for (const [name, text] of Object.entries(generated()))
  test(`${name} is what the netlists give (else: node firmware/board/board.mjs write)`, () =>
    assert.equal(readFileSync(join(kBoardFolder, name), "utf8"), text));

test("the firmware's pins are the board's", (context) => {
  const path = join(kBoardFolder, "../pins.h");
  if (!existsSync(path)) return context.skip("there is no firmware for it here");
  const first = { PWM: "kPwmPin", DIR: "kDirPin", FLT: "kFaultPin" };
  const single = { SLP: "kSleepPin", FAN_CTL: "kFanPin", TACH: "kTachPin", SWITCH: "kSupplySwitchPin", SPI_OUT: "kSpiInPin",
    SPI_CS: "kSpiSelectPin", SPI_CLK: "kSpiClockPin", SPI_IN: "kSpiOutPin" };
  const pin = (name) => constant("firmware/pins.h", new RegExp(`${name} = (\\d+);`));
  for (const board of [reference, thesis]) {
    const net = (number) => board.parts.get("U1").pins.get(`GP${number}`);
    for (const [name, at] of Object.entries(single)) assert.equal(net(pin(at)), name);
    for (const [name, at] of Object.entries(first))
      ["A", "B", "C"].forEach((letter, k) => assert.equal(net(pin(at) + k), `${name}_${letter}`));
  }
});

test("the page on sleep has the calculated figures", () => {
  const text = prose(sourceText("firmware/board/asleep-at-once.md"));
  const { cases, bare, stuckJ, farads, brakeS } = safeWays(reference, kTypes);
  const texts = [`13.2 → ${cases[0].peakV.toFixed(1)} V; all three at 18 A: ${cases[2].peakV.toFixed(1)} V`,
    `${cases[0].returnedJ.toFixed(2)} J of it come back`, `after ${(1e3 * cases[0].seconds).toFixed(1)} ms`,
    `VM would reach ${bare.peakV.toFixed(0)} V`, `${stuckJ.toFixed(1)} J |`, `${(1e3 * farads[0].farad).toFixed(2)} mF hold 24 V`,
    `want ${(1e3 * farads[1].farad).toFixed(1)} mF`, `5 L/R = ${(1e3 * brakeS).toFixed(0)} ms`];
  for (const one of texts) assert.ok(text.includes(one), one);
});
