// SPDX-License-Identifier: MIT
// The boards of the project, unchanged and with one change.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

import { violations } from "../../firmware/board/check.mjs";
import { kBoardFolder, parseBoard, readParts } from "../../firmware/board/netlist.mjs";

export const kTypes = readParts();
export const sourceText = (path) => readFileSync(join(kBoardFolder, "../..", path), "utf8");
/** A document without its line breaks: a sentence is found wherever its lines end. */
export const prose = (document) => document.replace(/\s+/g, " ");
const text = (name) => readFileSync(join(kBoardFolder, name), "utf8");

/** The board `name` with every `cut` in its netlist replaced by `put`, and the lines `more` at its end. */
export function changed(name, cut, put, more = "") {
  let count = 0;
  const edit = (source) => source.replaceAll(cut, () => {
    ++count;
    return put;
  });
  const board = parseBoard(edit(text(`${name}.net`)) + more, kTypes, (file) => edit(text(file)));
  if (cut !== "") assert.ok(count > 0, `nothing to cut: ${cut}`);
  return board;
}
export const asBuilt = (name) => changed(name, "", "");

/** Asserts that the change violates exactly the rules in `names`, and that one of the messages matches `like`. */
export function breaks(names, like, cut, put, more = "", board = "reference") {
  const found = violations(changed(board, cut, put, more), kTypes);
  assert.deepEqual([...new Set(found.map((one) => one.split(":")[0]))].sort(), [...names].sort(), found.join("\n"));
  assert.ok(found.some((one) => like.test(one)), found.join("\n"));
}
