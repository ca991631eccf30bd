// SPDX-License-Identifier: MIT
// Parses every script of the addon with a grammar of GDScript for Godot 4, which Debian 12 does not package.
import assert from "node:assert/strict";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const packages = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const Parser = packages("tree-sitter");
const parser = new Parser();
parser.setLanguage(packages("tree-sitter-gdscript"));

const addon = fileURLToPath(new URL("../../../clients/godot", import.meta.url));
const scripts = fs.readdirSync(addon, { recursive: true }).filter((name) => name.endsWith(".gd"));

/** The numbers of the lines with syntax errors. */
function syntaxErrors(text) {
  const found = [];
  const visit = (node) => {
    if (node.type === "ERROR" || node.isMissing) found.push(node.startPosition.row + 1);
    node.children.forEach(visit);
  };
  // The parser accepts texts longer than 32 KiB only in parts.
  visit(parser.parse((at) => text.slice(at, at + 4096)).rootNode);
  return found;
}

test("there are scripts", () => assert.ok(scripts.length > 8));

test("what is no GDScript is found", () => assert.notDeepEqual(syntaxErrors("func f():\n\treturn ]\n"), []));

for (const script of scripts)
  test(`${script} is GDScript`, () => {
    assert.deepEqual(syntaxErrors(fs.readFileSync(path.join(addon, script), "utf8")), []);
  });
