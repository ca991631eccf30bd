// SPDX-License-Identifier: MIT
// The rules of a board's budgets: current of each rail and pin, power of each resistor, what converters can show, what
// the supply of the bridges takes when they fall asleep.
import { circuitAt, fullScale } from "./circuits.mjs";
import { sleepAtFullCurrent } from "./flyback.mjs";
import { pinsOn, resistorsOn } from "./netlist.mjs";

/** The most that `net` draws from its source, mA: pins, resistors as if their other end were at ground, rails behind. */
export function drawnMa(board, types, net) {
  let ma = 0;
  for (const pin of pinsOn(board, types, net)) {
    ma += pin.draws_ma ?? 0;
    for (const [name, other] of types.get(pin.part.type).pins)
      if (other.kind === "source" && other.from === pin.name && pin.part.pins.get(name))
        ma += drawnMa(board, types, pin.part.pins.get(name));
  }
  const volts = board.nets.get(net).max;
  for (const { part, other } of resistorsOn(board, net))
    ma += 1e3 * Math.max(0, volts - (other === "GND" ? 0 : Math.min(0, board.nets.get(other)?.min ?? 0))) / part.value;
  // What the microcontroller itself takes: RP2040 at 125 MHz with USB, and its regulator.
  if (net === "VBUS") ma += 100;
  return ma;
}

/** RP2040 data sheet, 2.19.6.3. */
const kDrivesMa = [2, 4, 8, 12];

/** What the firmware sets a pin of the microcontroller to, mA: as the netlist says, else as in reset. */
export const driveMa = (board, part, pin) => board.drives.get(`${part.ref}.${pin}`) ?? part.drive_ma;

/** Each source gives what its rail draws; each pin of the microcontroller what its resistors draw. */
export function currents(board, types) {
  const found = [];
  for (const part of board.parts.values()) {
    let ioMa = 0;
    for (const [name, pin] of types.get(part.type).pins) {
      const net = part.pins.get(name);
      if (!net) continue;
      if (pin.kind === "source" && pin.gives_ma) {
        const ma = drawnMa(board, types, net);
        if (ma > pin.gives_ma) found.push(`${part.ref}.${name} gives ${pin.gives_ma} mA, ${net} draws ${ma.toFixed(1)} mA`);
      }
      if (pin.kind !== "io") continue;
      const ma = resistorsOn(board, net).reduce((sum, { part: resistor, other }) =>
        sum + (other === "GND" || other === "3V3" ? 1e3 * 3.4 / resistor.value : 0), 0);
      ioMa += ma;
      const at = `${part.ref}.${name}`;
      const drive = driveMa(board, part, name);
      if (!kDrivesMa.includes(drive) || drive > pin.gives_ma) found.push(`${at} has no drive of ${drive} mA`);
      else if (ma > drive) found.push(`${at} gives ${drive} mA, ${net} takes ${ma.toFixed(1)} mA`);
    }
    if (part.io_total_ma && ioMa > part.io_total_ma) found.push(`${part.ref}: ${ioMa.toFixed(0)} mA of all its pins, ${part.io_total_ma} mA allowed`);
  }
  return found;
}

/** A board without a supply of its own draws from VBUS what its descriptor asks for, which is at most 500 mA (USB 2.0, 7.2.1). */
export function usbPower(board, types) {
  const ma = drawnMa(board, types, "VBUS");
  const found = [];
  if (!(board.usbMa <= 500)) found.push(`the descriptor asks for ${board.usbMa} mA`);
  if (!(ma <= board.usbMa)) found.push(`VBUS draws ${ma.toFixed(1)} mA, the descriptor asks for ${board.usbMa} mA`);
  return found;
}

/** Parts in the way of the power carry the fuse's current, the fuse a quarter more than the load's. */
export function powerPath(board, types) {
  const found = [];
  const fuse = [...board.parts.values()].find(({ kind }) => kind === "fuse");
  for (const net of board.nets.values()) {
    if (net.amps === undefined) continue;
    const bridges = pinsOn(board, types, net.name).some(({ kind }) => kind === "bridge");
    const fused = pinsOn(board, types, net.name).some(({ part }) => board.way.through.includes(part.ref));
    const amps = fused && !bridges ? Math.max(net.amps, fuse.value) : net.amps;
    if (fused && fuse.value < 1.25 * net.amps) found.push(`${fuse.ref} blows at ${fuse.value} A, ${net.name} carries ${net.amps} A`);
    for (const pin of pinsOn(board, types, net.name)) {
      if (pin.amps !== undefined && pin.amps < amps) found.push(`${pin.part.ref}.${pin.name} carries ${pin.amps} A, ${net.name} has ${amps} A`);
      if (pin.part.kind === "shunt" && !pin.name.startsWith("S")) {
        const watts = amps * amps * pin.part.value;
        if (watts > 0.6 * pin.part.power) found.push(`${pin.part.ref}: ${watts.toFixed(2)} W of ${pin.part.power} W`);
      }
    }
  }
  return [...new Set(found)];
}

/** No resistor takes more than half of its power. */
export function resistorPower(board) {
  const found = [];
  for (const part of board.parts.values()) {
    if (part.kind !== "resistor") continue;
    const [a, b] = ["1", "2"].map((name) => board.nets.get(part.pins.get(name)));
    if (!a || !b) continue;
    const volts = Math.max(a.max - b.min, b.max - a.min);
    const watts = volts * volts / part.value;
    if (watts > part.power / 2) found.push(`${part.ref}: up to ${watts.toFixed(3)} W, more than half of ${part.power} W`);
  }
  return found;
}

/** At both ends of what is to be measured, amplifier and converter are within their range. */
export function converterRange(board, types) {
  const found = [];
  for (const { name, at, min, max, unit } of board.measures) {
    const circuit = circuitAt(board, types, at);
    if (!circuit) {
      found.push(`${name}: no amplifier, divider, thermistor or driver in front of ${at}`);
      continue;
    }
    const full = fullScale(board, at);
    for (const value of [min, max]) {
      const volts = circuit.volts(value);
      const [low, high] = [Math.max(0, circuit.low), Math.min(full, circuit.high)];
      if (volts < low || volts > high)
        found.push(`${name}: ${value} ${unit} gives ${volts.toFixed(3)} V, ${at} shows ${low.toFixed(2)}..${high.toFixed(2)} V`);
    }
  }
  return found;
}

/** Nets that VM lifts: through fuses, the closed switch and shunts. */
function liftedNets(board) {
  const seen = new Set(["VM"]);
  for (const net of seen)
    for (const part of board.parts.values()) {
      if (!["fuse", "polyfuse", "switch", "shunt"].includes(part.kind)) continue;
      const ends = ["1", "2", "VS", "OUT"].map((name) => part.pins.get(name)).filter(Boolean);
      // Shunts in the windings' leads are behind the bridges.
      if (ends.includes(net)) for (const end of ends) seen.add(end);
    }
  return seen;
}

/** Bridges that fall asleep at full current lift their supply, and all that is before the closed switch, no further than each part stands. */
export function sleepingBridges(board, types) {
  const driver = types.get("G2_18V17");
  const found = [];
  for (const { what, peakV, clampJ, limitV, energyJ } of sleepAtFullCurrent(board, types)) {
    if (peakV > limitV) found.push(`${what}: VM rises to ${peakV.toFixed(1)} V, ${limitV} V allowed (${driver.name})`);
    if (clampJ > energyJ) found.push(`${what}: the clamp takes ${clampJ.toFixed(2)} J of ${energyJ} J`);
    for (const net of liftedNets(board))
      for (const { part, name, peak_v, v } of pinsOn(board, types, net)) {
        const stands = part.volts ?? peak_v ?? v?.max;
        if (part.kind !== "driver" && peakV > stands) found.push(`${what}: ${part.ref}.${name} stands ${stands} V, ${net} rises to ${peakV.toFixed(1)} V`);
      }
  }
  return found;
}
