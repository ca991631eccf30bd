// SPDX-License-Identifier: MIT
// The electrical rules of a board's netlist: form, drivers, voltages, decoupling. Each rule gives a sentence for each
// thing that breaks it. rules_safe.mjs, rules_budget.mjs: levels at reset; currents, powers, converters.
import { capacitorsOn, pinsOn, resistorsOn } from "./netlist.mjs";

const kDrives = new Set(["source", "analog_out", "bridge"]);
const kReads = new Set(["in", "adc", "sense", "reference"]);
const at = ({ part, name }) => `${part.ref}.${name}`;

/** Each pin of each part is on one net or expressly unused; each net is declared and has two pins or more. */
export function connections(board, types) {
  const found = [...board.problems];
  for (const part of board.parts.values())
    for (const [name, pin] of types.get(part.type).pins) {
      if (!part.pins.has(name)) {
        if (pin.kind !== "nc") found.push(`${part.ref}.${name} is not connected`);
      } else if (pin.kind === "nc" && part.pins.get(name)) {
        found.push(`${part.ref}.${name} must stay free`);
      }
    }
  for (const net of board.nets.values()) {
    const count = pinsOn(board, types, net.name).length;
    if (count < 2) found.push(`net ${net.name} has ${count === 1 ? "one pin" : "no pin"}`);
    if (Number.isNaN(net.min)) found.push(`net ${net.name} has no range of voltage`);
  }
  for (const part of board.parts.values())
    for (const [name, net] of part.pins)
      if (net && !board.nets.has(net)) found.push(`${part.ref}.${name}: net ${net} is not declared`);
  for (const free of board.free) {
    const [ref, pin] = free.split(".");
    if (board.parts.get(ref)?.pins.get(pin)) found.push(`${free} must stay free`);
  }
  return found;
}

/** No net is driven by two, none that is read by nobody; an open drain has a pull-up. */
export function drivers(board, types) {
  const found = [];
  for (const net of board.nets.keys()) {
    const pins = pinsOn(board, types, net);
    const strong = pins.filter(({ kind }) => kDrives.has(kind));
    // A microcontroller's pin is an output where nothing else drives.
    const others = pins.filter(({ kind }) => kind === "tristate" || kind === "opendrain");
    if (net !== "GND" && strong.length > 1) found.push(`net ${net} is driven by ${strong.map(at).join(" and ")}`);
    if (strong.length > 0 && others.length > 0 && net !== "GND")
      found.push(`net ${net} is driven by ${at(strong[0])} against ${at(others[0])}`);
    if (pins.filter(({ kind }) => kind === "io").length > 1) found.push(`net ${net} joins two pins of the microcontroller`);
    const readers = pins.filter(({ kind }) => kReads.has(kind));
    const given = pins.some(({ kind }) => kDrives.has(kind) || ["io", "tristate", "opendrain", "passive", "ground"].includes(kind));
    if (readers.length > 0 && !given) found.push(`net ${net}: nothing drives ${at(readers[0])}`);
    const drains = pins.filter(({ kind }) => kind === "opendrain");
    const up = resistorsOn(board, net).some(({ other }) => board.nets.get(other)?.min > 2.5) ||
      pins.some(({ pull }) => pull?.to === "up");
    if (drains.length > 0 && !up) found.push(`net ${net}: open drain of ${at(drains[0])} without a pull-up`);
  }
  return found;
}

/** What a net can have is within what each of its pins stands. */
export function voltages(board, types) {
  const found = [];
  for (const net of board.nets.values())
    for (const pin of pinsOn(board, types, net.name)) {
      if (pin.kind === "ground" && net.name !== "GND") found.push(`${at(pin)} is not on GND`);
      if (!pin.v) continue;
      const [low, high] = pin.kind === "supply" ? [pin.v.min, pin.v.max] : [Math.min(pin.v.min, 0), pin.v.max];
      if (net.max > high) found.push(`${at(pin)} stands ${high} V, net ${net.name} has up to ${net.max} V`);
      if (net.min < low) found.push(`${at(pin)} needs ${low} V, net ${net.name} has down to ${net.min} V`);
    }
  for (const part of board.parts.values()) {
    if (part.kind !== "capacitor") continue;
    const highest = Math.max(...[...part.pins.values()].map((net) => board.nets.get(net)?.max ?? 0));
    if (!(part.volts >= 1.25 * highest)) found.push(`${part.ref} stands ${part.volts} V at ${highest} V: less than 1.25 times`);
  }
  return found;
}

/** A capacitor beside each supply pin that wants one, and one at each converter's input. */
export function decoupling(board, types) {
  const found = [];
  for (const part of board.parts.values())
    for (const [name, pin] of types.get(part.type).pins) {
      const net = part.pins.get(name);
      if (!net || net === "GND") continue;
      const near = capacitorsOn(board, net).filter(({ at: place }) => place === part.ref);
      const farad = near.reduce((sum, { value }) => sum + value, 0);
      for (const [key, what] of [["decouple", "decoupling"], ["reservoir", "input"]])
        if (pin[key] !== undefined && !(farad >= pin[key]))
          found.push(`${part.ref}.${name} has ${farad * 1e9} nF beside it, needs ${Math.round(pin[key] * 1e9)} nF (${what})`);
    }
  return found;
}
