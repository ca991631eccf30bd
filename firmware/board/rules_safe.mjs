// SPDX-License-Identifier: MIT
// The rules of a board that nobody drives: levels with the microcontroller in reset, unprogrammed or without supply,
// and the only way of the supply to the bridges.
import { pinsOn, resistorsOn } from "./netlist.mjs";

/** Nets that follow the USB supply: 0 V without it. */
const kFromUsb = new Set(["VBUS", "3V3", "AVDD"]);

/** Lowest and highest level of `net` while no output drives it, V; null when nothing holds it. */
export function restingLevel(board, types, net, state) {
  const ways = [];  // {ohmMin, ohmMax, voltsMin, voltsMax}
  for (const { part, other } of resistorsOn(board, net)) {
    const end = board.nets.get(other);
    const fixed = other === "GND" || pinsOn(board, types, other).some(({ kind }) => kind === "source");
    if (!fixed) continue;
    const off = state === "unpowered" && kFromUsb.has(other);
    const span = off ? { min: 0, max: 0 } : end;
    ways.push({ ohmMin: part.value * (1 - part.tol), ohmMax: part.value * (1 + part.tol), voltsMin: span.min, voltsMax: span.max });
  }
  for (const pin of pinsOn(board, types, net))
    for (const pull of [pin.pull, state === "reset" ? pin.reset : null]) {
      if (!pull) continue;
      ways.push({ ohmMin: pull.min, ohmMax: pull.max, voltsMin: pull.volts, voltsMax: pull.volts });
    }
  if (ways.length === 0) return null;
  const level = (high) => {
    // Worst case: what pulls the wrong way is strong, what pulls the right way weak.
    const volts = ways.map((way) => (high ? way.voltsMax : way.voltsMin));
    const middle = (Math.max(...volts) + Math.min(...volts)) / 2;
    let sum = 0;
    let all = 0;
    ways.forEach((way, i) => {
      const siemens = 1 / ((volts[i] > middle) === high ? way.ohmMin : way.ohmMax);
      sum += siemens * volts[i];
      all += siemens;
    });
    return sum / all;
  };
  return { low: level(false), high: level(true) };
}

/** Each line that must be safe while nobody drives it is. */
export function safeLevels(board, types) {
  const found = [];
  for (const { net, level, states } of board.safe)
    for (const state of states) {
      const inputs = pinsOn(board, types, net).filter(({ kind }) => kind === "in");
      const rest = restingLevel(board, types, net, state);
      if (!rest) {
        found.push(`${net}: nothing holds it ${level} (${state})`);
        continue;
      }
      const vil = Math.min(...inputs.map((pin) => pin.vil));
      const vih = Math.max(...inputs.map((pin) => pin.vih));
      if (level === "low" && rest.high > vil) found.push(`${net}: up to ${rest.high.toFixed(2)} V (${state}), low is ${vil} V or less`);
      if (level === "high" && rest.low < vih) found.push(`${net}: down to ${rest.low.toFixed(2)} V (${state}), high is ${vih} V or more`);
    }
  return found;
}

/** Each input of a bridge and of the supply switch has such a line. */
export function safeLinesNamed(board, types) {
  const found = [];
  for (const part of board.parts.values()) {
    if (part.kind !== "driver" && part.kind !== "switch") continue;
    for (const [name, pin] of types.get(part.type).pins)
      if (pin.kind === "in" && !board.safe.some(({ net }) => net === part.pins.get(name)))
        found.push(`${part.ref}.${name}: no safe level is named for ${part.pins.get(name)}`);
  }
  return found;
}

/** Current goes from the supply to the bridges only through fuse, switch and shunt, in this order. */
export function onlyWay(board, types) {
  const { from, to, through } = board.way;
  const neighbours = (net, without) => {
    const nets = [];
    for (const part of board.parts.values()) {
      if (part === without || !["fuse", "polyfuse", "switch", "shunt", "resistor"].includes(part.kind)) continue;
      const ends = ["1", "2", "VS", "OUT"].map((name) => part.pins.get(name)).filter(Boolean);
      if (ends.includes(net)) nets.push(...ends.filter((end) => end !== net && end !== "GND"));
    }
    return nets;
  };
  const reaches = (without) => {
    const seen = new Set([from]);
    for (const net of seen) for (const next of neighbours(net, without)) seen.add(next);
    return seen.has(to);
  };
  const found = reaches(null) ? [] : [`nothing leads from ${from} to ${to}`];
  for (const ref of through)
    if (!board.parts.has(ref) || reaches(board.parts.get(ref))) found.push(`current reaches ${to} without ${ref}`);
  for (const part of board.parts.values())
    if (part.kind === "driver" && part.pins.get("VIN") !== to) found.push(`${part.ref} is not supplied from ${to}`);
  return found;
}
