// SPDX-License-Identifier: MIT
// figures.md: the error budgets, and bridges asleep at full current against bridges that brake before.
import { errorBudgetText } from "./error_budget.mjs";
import { braked, leastFarad, sleep, sleepAtFullCurrent } from "./flyback.mjs";

const kWindingJK = 58.81;  // heat capacity of a winding, as in daemon/control's model

/** Both ways for the board's own windings. */
export function safeWays(board, types) {
  const { winding } = board;
  const { henry, ohm, amps, chopAmps } = winding;
  const brakeS = 5 * henry / ohm;
  const storedJ = henry * amps * amps / 2;
  const startV = board.nets.get("VM").max;
  const stuckA = Math.min(chopAmps, startV / ohm * (1 - Math.exp(-brakeS * ohm / henry)));
  return {
    storedJ, brakeS, cases: sleepAtFullCurrent(board, types),
    farads: [1, 3].map((windings) => ({ windings, farad: leastFarad(winding, Array(windings).fill(windings === 1 ? amps : chopAmps), startV, 24) })),
    bare: sleep(winding, [amps], 100e-6, startV),
    brakedA: braked(winding, amps, brakeS), brakedJ: henry * braked(winding, amps, brakeS) ** 2 / 2,
    heatedK: storedJ / kWindingJK, brakedTo01AS: henry / ohm * Math.log(amps / 0.1),
    stuckA, stuckJ: stuckA * stuckA * ohm * brakeS,
  };
}

export function flybackText(board, types) {
  const ways = safeWays(board, types);
  const [one, even, three] = ways.cases;
  const mF = (farad) => `${(farad * 1e3).toFixed(2)} mF`;
  const ms = (seconds) => `${(seconds * 1e3).toFixed(1)} ms`;
  const startV = board.nets.get("VM").max;
  return [
    "## Bridges asleep at full current", "",
    `Stored: ${ways.storedJ.toFixed(2)} J at ${board.winding.amps} A, the norm of the three currents.`,
    `The supply takes nothing back; capacitors at the lower end of their tolerance.`, "",
    "| | returned | over | VM | clamp |", "|---|---|---|---|---|",
    `| asleep at once, ${board.winding.amps} A in one winding | ${one.returnedJ.toFixed(2)} J | ${ms(one.seconds)} | ${startV} → ${one.peakV.toFixed(1)} V | ${one.clampJ.toFixed(2)} J |`,
    `| the same, evenly in all three | ${even.returnedJ.toFixed(2)} J | ${ms(even.seconds)} | ${startV} → ${even.peakV.toFixed(1)} V | ${even.clampJ.toFixed(2)} J |`,
    `| asleep at once, ${board.winding.chopAmps} A in each (the drivers' own limit) | ${three.returnedJ.toFixed(2)} J | ${ms(three.seconds)} | ${startV} → ${three.peakV.toFixed(1)} V | ${three.clampJ.toFixed(2)} J |`,
    `| the first, with 100 µF and no clamp | ${ways.bare.returnedJ.toFixed(2)} J | ${ms(ways.bare.seconds)} | ${startV} → ${ways.bare.peakV.toFixed(0)} V | – |`,
    `| after a brake of 5 L/R = ${ms(ways.brakeS)} | ${(ways.brakedJ * 1e6).toFixed(0)} µJ | | unchanged | – |`, "",
    `Capacitance that holds VM at 24 V without a clamp: ${ways.farads.map(({ windings, farad }) => `${mF(farad)} (${windings === 1 ? "first" : "third"} row)`).join(", ")}.`,
    `In the brake ${ways.brakedA.toFixed(2)} A are left after 5 L/R and the winding is ${(ways.heatedK * 1e3).toFixed(1)} mK warmer;`,
    `a PWM line that is stuck during it drives up to ${ways.stuckA.toFixed(0)} A and ${ways.stuckJ.toFixed(1)} J into the winding.`, "",
  ].join("\n");
}

export const figures = (boards, types) => [
  "# Figures of the boards", "",
  "Written by `board.mjs write` from netlists and parts. *Combined*: root of the sum of squares of the limits; *sum*: all of them at their limit,",
  "with the same sign. Electronics between −5 and 55 °C, calibrated at 25 °C, the windings' currents through the converter",
  "([bring-up.md](bring-up.md), step 6).", "",
  ...boards.map((board) => errorBudgetText(board, types)), flybackText(boards[0], types),
].join("\n");
