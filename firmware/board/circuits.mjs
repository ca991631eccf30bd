// SPDX-License-Identifier: MIT
// What a converter's input sees of the quantity in front of it, derived from the netlist: amplifier over a shunt,
// divider, thermistor, a driver's own sensor.
import { pinsOn, resistorsOn } from "./netlist.mjs";

const kKelvin = 273.15;
export const ntcOhm = (ntc, celsius) =>
  ntc.r25_ohm * Math.exp(ntc.b_k * (1 / (celsius + kKelvin) - 1 / (25 + kKelvin)));

/** Nets that reach `net` through resistors of at most 10 k that are not a divider's. */
function sources(board, net) {
  const nets = [net];
  for (const { part, other } of resistorsOn(board, net))
    if (part.value <= 1100 && other !== "GND") nets.push(other);
  return nets;
}

function amplifier(board, types, out) {
  const amp = out.part;
  const [plus, minus] = [amp.pins.get("IN+"), amp.pins.get("IN-")];
  const shunt = [...board.parts.values()].find((part) =>
    part.kind === "shunt" && part.pins.get("S1") === plus && part.pins.get("S2") === minus);
  if (!shunt) return null;
  const supply = board.nets.get(amp.pins.get("VS"));
  const references = ["REF1", "REF2"].filter((name) => amp.pins.get(name) === amp.pins.get("VS")).length;
  const zero = references / 2 * supply.min;
  return {
    kind: "amplifier", amp, shunt, zero, voltsPerUnit: amp.gain * shunt.value,
    volts: (amps) => zero + amp.gain * shunt.value * amps,
    low: references > 0 ? amp.low_v : 0, high: supply.min - amp.high_below_supply_v,
  };
}

function thermistor(board, net) {
  const pin = [...board.parts.values()].find((part) =>
    part.kind === "thermistor" && [...part.pins.values()].includes(net));
  const up = resistorsOn(board, net).find(({ part, other }) => part.value > 1100 && other !== "GND");
  if (!pin || !up) return null;
  const reference = board.nets.get(up.other);
  const share = (celsius) => ntcOhm(pin, celsius) / (ntcOhm(pin, celsius) + up.part.value);
  // port.cpp takes the outer hundredths for an open and a shorted line.
  return { kind: "thermistor", ntc: pin, pullUp: up.part, share, volts: (celsius) => reference.min * share(celsius),
    low: 0.01 * reference.max, high: 0.99 * reference.min };
}

function divider(board, net) {
  const ends = resistorsOn(board, net);
  const lower = ends.find(({ other }) => other === "GND");
  const upper = ends.find(({ other }) => other !== "GND");
  if (!lower || !upper) return null;
  const share = lower.part.value / (lower.part.value + upper.part.value);
  return { kind: "divider", upper: upper.part, lower: lower.part, share, volts: (volts) => share * volts, low: 0, high: Infinity };
}

/** The circuit at `at` ("U7.CH0"), or null. */
export function circuitAt(board, types, at) {
  const [ref, pin] = at.split(".");
  const net = board.parts.get(ref)?.pins.get(pin);
  if (!net) return null;
  for (const source of sources(board, net)) {
    const found = thermistor(board, source);
    if (found) return found;
    const out = pinsOn(board, types, source).find(({ kind }) => kind === "analog_out");
    if (out?.part.kind === "amplifier") return amplifier(board, types, out);
    if (out?.part.kind === "driver") {
      const { sense_zero_v: zero, sense_v_per_a: gain } = out.part;
      return { kind: "driver_cs", voltsPerUnit: gain, zero, volts: (amps) => zero + gain * amps, low: 0, high: Infinity };
    }
  }
  return divider(board, net);
}

/** Full scale of the converter that `at` belongs to, V, at the least. */
export function fullScale(board, at) {
  const part = board.parts.get(at.split(".")[0]);
  const net = part.pins.get("VREF") ?? "3V3";
  return board.nets.get(net).min;
}
