#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// board.mjs check: the electrical rules of both boards. board.mjs write: bills of materials, diagrams and figures.md beside
// this file. Exit: 0, 1 a rule is broken, 64 usage.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { bomCsv } from "./bom.mjs";
import { diagram } from "./diagram.mjs";
import { figures } from "./figures.mjs";
import { kBoardFolder, readBoard, readParts } from "./netlist.mjs";
import { kRules, violations } from "./check.mjs";

export const kBoards = ["reference", "thesis"];

/** Lines of the check's output, and the number of violations. */
function report(types) {
  let broken = 0;
  const lines = kBoards.flatMap((name) => {
    const board = readBoard(name);
    const found = violations(board, types);
    broken += found.length;
    return [`${name}: ${board.parts.size} parts, ${board.nets.size} nets, ${kRules.length} rules, ${found.length} broken`, ...found.map((text) => `  ${text}`)];
  });
  return { lines, broken };
}

function check() {
  const { lines, broken } = report(readParts());
  console.log(lines.join("\n"));
  return broken === 0 ? 0 : 1;
}

/** Text of each file that is made from the netlists, by its name. */
export function generated() {
  const types = readParts();
  const rules = ["## Electrical rules", "", "Output of `board.mjs check`:", "", ...report(types).lines.map((line) => `    ${line}`), ""];
  const files = { "figures.md": `${figures(kBoards.map(readBoard), types)}\n${rules.join("\n")}` };
  for (const name of kBoards) {
    files[`bom-${name}.csv`] = bomCsv(readBoard(name));
    files[`wiring-${name}.svg`] = diagram(readBoard(name), types);
  }
  return files;
}

function write() {
  for (const [name, text] of Object.entries(generated())) writeFileSync(join(kBoardFolder, name), text);
  return 0;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const run = process.argv.length === 3 ? { check, write }[process.argv[2]] : undefined;
  if (!run) console.error("board.mjs check | write");
  process.exitCode = run ? run() : 64;
}
