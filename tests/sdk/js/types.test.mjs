// SPDX-License-Identifier: MIT
// The types of the package installed by npm, checked by the TypeScript compiler.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { installed } from "./installed.mjs";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
let library;

before(() => {
  library = installed();
  for (const name of ["sample.ts", "tsconfig.json"]) fs.copyFileSync(here(`types/${name}`), path.join(library.folder, name));
});

after(() => library.remove());

function compile(...more) {
  const compiler = path.join(process.env.HEDGEHOG_TYPESCRIPT, "typescript/bin/tsc");
  const { status, stdout } = spawnSync(process.execPath, [compiler, "--project", ".", ...more], { cwd: library.folder, encoding: "utf8" });
  return { status, stdout };
}

test("a strict compiler accepts valid programs and rejects type errors", () => {
  assert.deepEqual(compile(), { status: 0, stdout: "" });
});

test("the compiler has read the declarations of the package, none is left out", () => {
  const declarations = compile("--listFilesOnly").stdout;
  for (const name of ["index", "messages", "methods"]) assert.match(declarations, new RegExp(`@hedgehog/client/${name}\\.d\\.ts`));
});

test("every declared name exists at run time", async () => {
  const { ErrorCode, RequestError } = await import(path.join(library.folder, "node_modules/@hedgehog/client/src/node.js"));
  const declared = fs.readFileSync(path.join(library.folder, "node_modules/@hedgehog/client/messages.d.ts"), "utf8");
  const codes = [...declared.matchAll(/readonly (\w+): (-\d+);/g)].map(([, name, code]) => [name, Number(code)]);
  assert.ok(codes.length > 10);
  assert.deepEqual(Object.fromEntries(codes), { ...ErrorCode });
  assert.equal(new RequestError(ErrorCode.busy, "", { name: "busy" }).reason, "busy");
});
