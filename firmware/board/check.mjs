// SPDX-License-Identifier: MIT
// All electrical rules of a board.
import { connections, decoupling, drivers, voltages } from "./rules.mjs";
import { converterRange, currents, powerPath, resistorPower, sleepingBridges, usbPower } from "./rules_budget.mjs";
import { onlyWay, safeLevels, safeLinesNamed } from "./rules_safe.mjs";

export const kRules = [connections, drivers, voltages, decoupling, safeLevels, safeLinesNamed, onlyWay, currents, usbPower, powerPath,
  resistorPower, converterRange, sleepingBridges];

/** A sentence for everything that breaks a rule, each with the rule's name. */
export const violations = (board, types) =>
  kRules.flatMap((rule) => rule(board, types).map((text) => `${rule.name}: ${text}`));
