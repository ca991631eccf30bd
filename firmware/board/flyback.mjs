// SPDX-License-Identifier: MIT
// What windings give back to the supply of the bridges when these fall asleep at full current, and what it would be
// after a brake. The supply itself takes nothing back.
import { capacitorsOn } from "./netlist.mjs";

const kDiodeV = 0.8;
const kStepS = 1e-6;

/** `amps`: of each winding. {peakV, seconds until no current flows, returnedJ, clampJ} */
export function sleep({ henry, ohm }, amps, farad, startV, clamp) {
  const current = [...amps];
  let volts = startV;
  const result = { peakV: startV, seconds: 0, returnedJ: 0, clampJ: 0 };
  while (current.some((i) => i > 0)) {
    let into = 0;
    for (let k = 0; k < current.length; ++k) {
      into += current[k];
      current[k] = Math.max(0, current[k] - (volts + 2 * kDiodeV + ohm * current[k]) / henry * kStepS);
    }
    const clamped = clamp && volts > clamp.breakdown_v
      ? (volts - clamp.breakdown_v) * clamp.clamp_a / (clamp.clamp_v - clamp.breakdown_v) : 0;
    volts += (into - clamped) / farad * kStepS;
    result.peakV = Math.max(result.peakV, volts);
    result.returnedJ += volts * into * kStepS;
    result.clampJ += volts * clamped * kStepS;
    result.seconds += kStepS;
  }
  return result;
}

/** Least capacitance that keeps VM below `limitV` without a clamp, F. */
export function leastFarad(winding, amps, startV, limitV) {
  let [low, high] = [1e-5, 1];
  for (let i = 0; i < 40; ++i) {
    const middle = Math.sqrt(low * high);
    if (sleep(winding, amps, middle, startV).peakV > limitV) low = middle;
    else high = middle;
  }
  return high;
}

/** Current after a brake of `seconds`, A. */
export const braked = ({ henry, ohm }, amps, seconds) => amps * Math.exp(-seconds * ohm / henry);

/** The cases that the board must stand: what its rules let flow, and what its drivers do when the rules have failed. */
export function sleepAtFullCurrent(board, types) {
  const { winding } = board;
  const vm = board.nets.get("VM");
  const farad = capacitorsOn(board, "VM").reduce((sum, { value, tol }) => sum + value * (1 - tol), 0);
  const clamp = [...board.parts.values()].find(({ kind, pins }) => kind === "clamp" && pins.get("K") === "VM");
  const driver = types.get("G2_18V17");
  const energyJ = clamp?.energy_j ?? 0;
  if (farad === 0) return [{ what: "no capacitor at VM", peakV: Infinity, clampJ: 0, limitV: driver.practical_v, energyJ, farad }];
  return [
    { what: "16.5 A in one winding", amps: [winding.amps], limitV: driver.practical_v },
    { what: "16.5 A, evenly in all windings", amps: [1, 1, 1].map(() => winding.amps / Math.sqrt(3)), limitV: driver.practical_v },
    { what: "all windings where the drivers chop", amps: [1, 1, 1].map(() => winding.chopAmps), limitV: driver.practical_v },
  ].map((one) => ({ ...one, ...sleep(winding, one.amps, farad, vm.max, clamp), energyJ, farad }));
}
