// SPDX-License-Identifier: MIT
// By how much each measured quantity of a board may be off, from the figures of its parts. Each contribution is a limit
// (not a standard deviation); independent ones are combined as the root of the sum of squares, the plain sum beside it.
import { circuitAt, fullScale, ntcOhm } from "./circuits.mjs";
import { capacitorsOn, resistorsOn } from "./netlist.mjs";

/** The electronics are between -5 and 55 C, calibrated at 25. */
export const kElectronicsK = 30;
/** Of the telemetry in a mean (bring-up.md, step 6). */
const kReadings = 500;
const kCalibratedA = 5;
/** A multimeter or ammeter that one has, and its clamp. */
const kMeter = 0.005;
const kWindingA = 16.5;
const kSelfHeatingK = 15;  // of a 1 W shunt at 0.27 W
/** RP2040's own converter: effective bits by its data sheet; pico-adc.markomo.me measured 7.9 to 8.9. */
const kOwnConverterBits = 8.7;
const kOwnConverterInlLsb = 7.85;
/** INA240: 40 nV per root hertz (TI SBOS662C, from memory), bandwidth 400 kHz for a gain of 50. */
const kAmplifierNoiseV = 40e-9;
const kAmplifierHz = 400e3;
const kPwmHz = 20e3;
/** What is left in the shunt, peak to peak, of 15 A that are switched: 10 mOhm of the capacitors at VM against 1 uH of leads. */
const kSupplyRippleA = 15 * 0.010 / (2 * Math.PI * kPwmHz * 1e-6);
/** By which a sampling point may be beside the middle of the on-time: the drivers' delay is not published (assumed: up to 1 us). */
const kOffCentreS = 1e-6;

const sum = (list) => list.reduce((total, [, value]) => total + value, 0);
export const root = (list) => Math.sqrt(list.reduce((total, [, value]) => total + value * value, 0));
const budget = (name, unit, list) => ({ name, unit, list, combined: root(list), worst: sum(list) });

const reference = (types) => types.get("REF3033");
const drift = (ppm, kelvin = kElectronicsK) => ppm * 1e-6 * kelvin;
const lsb = (board, at) => fullScale(board, at) / 4096;

/** Time constant in front of a converter's input, s. */
function filterSeconds(board, at) {
  const [ref, pin] = at.split(".");
  const net = board.parts.get(ref).pins.get(pin);
  const ohm = resistorsOn(board, net).find(({ other }) => other !== "GND").part.value;
  return ohm * capacitorsOn(board, net).reduce((farad, { value }) => farad + value, 0);
}

function inLine(board, types, name, at) {
  const circuit = circuitAt(board, types, at);
  const { amp, shunt, voltsPerUnit } = circuit;
  const converter = types.get("MCP3208");
  const step = lsb(board, at) / voltsPerUnit;
  const ohm = board.parts.get(shunt.ref);
  const later = [
    ["shunt, drift", drift(ohm.drift_ppm)], ["shunt, self-heating", drift(ohm.drift_ppm, kSelfHeatingK)],
    ["amplifier, drift", drift(amp.gain_drift_ppm)], ["reference, drift", drift(reference(types).drift_ppm)],
    ["converter, linearity", converter.inl_lsb * step / kWindingA],
  ];
  const gain = [["shunt", ohm.tol], ["amplifier", amp.gain_error], ["reference", reference(types).error],
    ["converter, gain", converter.gain_error_lsb / 4096], ...later];
  const zeroDrift = [["amplifier, drift", amp.offset_drift_uv_k * 1e-6 * kElectronicsK / shunt.value],
    ["half a step", step / 2]];
  const divided = circuit.zero > 0 ? [["divider of the zero", amp.divider_error * circuit.zero / voltsPerUnit],
    ["converter, gain at the zero", converter.gain_error_lsb * step * circuit.zero / fullScale(board, at)]] : [];
  const zero = [["amplifier", amp.offset_uv * 1e-6 / shunt.value], ...divided,
    ["converter, zero", converter.offset_lsb * step], ...zeroDrift];
  const seconds = filterSeconds(board, at);
  const band = Math.PI / 2 * Math.min(kAmplifierHz, 1 / (2 * Math.PI * seconds));
  const noise = [["amplifier", kAmplifierNoiseV * Math.sqrt(band) / shunt.value], ["resolution", step / Math.sqrt(12)]];
  // Conversions and PWM have one clock, and 20 periods are a millisecond: always the same phase of the ripple is converted. A winding's
  // is that of the mean, in the middle of the on-time, in which the current rises by supply (1 - d) / L.
  const bias = circuit.zero > 0
    ? [budget(`${name} bias while driven`, "A", [["1 us from the middle of the on-time, half the supply on", 12 * 0.5 / board.winding.henry * kOffCentreS]]),
      // Of a current supply d / R. An on-time below 2 us is over by then: half the ripple, supply d (1 - d) / (L f).
      budget(`${name} bias while driven, of the current`, "", [["half the ripple at 20 kHz, an on-time below 2 us",
        board.winding.ohm / (2 * board.winding.henry * kPwmHz)]])]
    : [budget(`${name} bias while driven`, "A", [["half the ripple at 20 kHz, half the supply on", kSupplyRippleA / (4 * kPwmHz * seconds) / 2]])];
  const mean = [["mean of the readings", root(noise) / Math.sqrt(kReadings)]];
  // Both are read through the converter, whose errors are in them; the supply's amplifier cannot show its zero.
  const calibrated = circuit.zero > 0
    ? [budget(`${name} gain, calibrated`, "", [["ammeter", kMeter],
      ["converter, linearity at 5 A each way", 2 * converter.inl_lsb * step / (2 * kCalibratedA)], ...later]),
      budget(`${name} zero`, "A", zero), budget(`${name} zero, calibrated`, "A", [...zeroDrift, ...mean])]
    : [budget(`${name} gain, calibrated`, "", [["ammeter", kMeter], ["voltmeter, two ranges", kMeter], ["converter, gain", converter.gain_error_lsb / 4096], ...later]),
      budget(`${name} zero`, "A", zero)];
  const floor = amp.floor_v ? [budget(`${name} floor`, "A", [["lowest output", amp.floor_v / voltsPerUnit]])] : [];
  return [...floor, budget(`${name} gain`, "", gain), ...calibrated, ...bias, budget(`${name} noise`, "A", noise)];
}

function driverCs(board, types, name, at) {
  const { voltsPerUnit } = circuitAt(board, types, at);
  const full = 3.3;
  const step = full / 2 ** kOwnConverterBits;
  return [
    budget(`${name} gain, calibrated`, "", [["ammeter", kMeter], ["3.3 V of the module, drift (assumed)", 0.005],
      ["linearity", kOwnConverterInlLsb * full / 4096 / voltsPerUnit / kWindingA]]),
    budget(`${name} zero, calibrated`, "A", [["linearity at the zero", 2 * full / 4096 / voltsPerUnit], ["half a step", full / 8192 / voltsPerUnit]]),
    budget(`${name} noise`, "A", [["converter, 8.7 bits", step / Math.sqrt(12) / voltsPerUnit]]),
  ];
}

function supply(board, types, name, at) {
  const { upper, lower, share } = circuitAt(board, types, at);
  const upperShare = upper.value / (upper.value + lower.value);
  const converter = types.get("MCP3208");
  const step = lsb(board, at) / share;
  return [
    budget(`${name} gain`, "", [["upper resistor", upper.tol * upperShare], ["lower resistor", lower.tol * upperShare],
      ["resistors, drift", 2 * drift(upper.drift_ppm) * upperShare], ["reference", reference(types).error],
      ["reference, drift", drift(reference(types).drift_ppm)], ["converter, gain", converter.gain_error_lsb / 4096],
      ["converter, zero and linearity", (converter.offset_lsb + converter.inl_lsb) * step / 12]]),
    budget(`${name} noise`, "V", [["resolution", step / Math.sqrt(12)], ["converter, half a step", step / 4]]),
  ];
}

/** K, at `celsius`; the reference drops out. */
export function thermistor(board, types, name, at, celsius) {
  const { ntc, pullUp, share } = circuitAt(board, types, at);
  const kelvinPerShare = 0.01 / Math.abs(share(celsius + 0.005) - share(celsius - 0.005));
  const perOhm = 1 / (Math.log(ntcOhm(ntc, celsius - 0.5)) - Math.log(ntcOhm(ntc, celsius + 0.5)));
  const inverse = Math.abs(1 / (celsius + 273.15) - 1 / 298.15);
  const current = fullScale(board, at) / (pullUp.value + ntcOhm(ntc, celsius));
  const converter = types.get("MCP3208");
  return budget(`${name} at ${celsius} C`, "K", [
    ["R25", ntc.r25_error * perOhm], ["B", ntc.b_error * ntc.b_k * inverse * perOhm],
    ["pull-up", pullUp.tol * perOhm], ["converter", (converter.inl_lsb + 1) / 4096 * kelvinPerShare],
    ["half a step", 0.5 / 4096 * kelvinPerShare], ["self-heating, 4 mW/K", current * current * ntcOhm(ntc, celsius) / 4e-3],
    ["table of the firmware", 0.2],
  ]);
}

/** Everything that the board measures. */
export function errorBudget(board, types) {
  return board.measures.flatMap(({ name, at }) => {
    const kind = circuitAt(board, types, at).kind;
    if (kind === "amplifier") return inLine(board, types, name, at);
    if (kind === "driver_cs") return driverCs(board, types, name, at);
    if (kind === "divider") return supply(board, types, name, at);
    return [25, 60, 75].map((celsius) => thermistor(board, types, name, at, celsius));
  });
}

const shown = (value, unit) => (unit === "" ? `${(100 * value).toFixed(2)} %` : `${value.toPrecision(2)} ${unit}`);

/** As a table of markdown; of three equal channels the first. */
export function errorBudgetText(board, types) {
  const rows = errorBudget(board, types).filter(({ name }) => !/_[bc]( |$)/.test(name)).map(({ name, unit, list, combined, worst }) =>
    `| ${name.replaceAll("_", " ")} | ${shown(combined, unit)} | ${shown(worst, unit)} | ${list.map(([what, value]) => `${what} ${shown(value, unit)}`).join(", ")} |`);
  return [`## ${board.title}`, "", "| quantity | combined | sum | of |", "|---|---|---|---|", ...rows, ""].join("\n");
}
