#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Writes src/methods.js and methods.d.ts from the OpenRPC document. With --check nothing is written; exit 1 says that a file is
// not what the document gives.
import fs from "node:fs";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const document = JSON.parse(fs.readFileSync(here("../../protocol/schema/openrpc.json"), "utf8"));

// Written by hand in src/ball.js.
const OWN = ["hello", "events.subscribe", "events.unsubscribe", "telemetry.subscribe", "telemetry.unsubscribe"];
// What a newcomer writes first may stand without its name.
const FIRST = ["direction", "axis", "pattern"];

const camel = (words) => words.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
function nameOf(method) {
  const [space, rest] = method.split(".");
  if (!rest) return space;
  return camel(space === "effect" || space === "device" ? rest : `${space}_${rest}`);
}
function typeOf(schema) {
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(" | ");
  if (schema.$ref) return schema.$ref.endsWith("/Direction") ? "Direction" : "unknown";
  if (schema.type === "array") return `Array<${typeOf(schema.items ?? {})}>`;
  return { number: "number", integer: "number", string: "string", boolean: "boolean", object: "object" }[schema.type] ?? "unknown";
}
function bounds(schema) {
  if (schema.minimum !== undefined && schema.maximum !== undefined) return `${schema.minimum} to ${schema.maximum}`;
  return schema.minimum !== undefined ? `at least ${schema.minimum}` : "";
}

const methods = document.methods.filter((method) => !OWN.includes(method.name));
const head = "// SPDX-License-Identifier: MIT\n// Written by generate.mjs from protocol/schema/openrpc.json.\n";
let code = head + "\n/** The daemon's methods; parameters by name, as protocol/README.md has them. */\nexport class Methods {\n";
let types = head + `
/** "left", [0, 1, 0], {azimuth_deg: 90} or {pin: 34}: where the pins push out. */
export type Direction =
  | "up" | "down" | "left" | "right" | "front" | "back"
  | [number, number, number]
  | { azimuth_deg?: number; elevation_deg?: number }
  | { pin: number };

/** A result, as protocol/README.md describes it. */
export type Result = Record<string, any>;

export declare class Methods {
`;
for (const method of methods) {
  const first = method.params.find((p) => FIRST.includes(p.name) && method.params.indexOf(p) === 0);
  const rest = method.params.filter((p) => p !== first);
  const args = first ? `${first.name}, params` : "params";
  const passed = first ? `{ ${first.name}, ...params }` : "params";
  code += `  /** ${method.summary} */\n  ${nameOf(method.name)}(${args}) {\n    return this.call("${method.name}", ${passed});\n  }\n`;
  const fields = rest.map((p) => {
    const what = [p.schema.description, bounds(p.schema)].filter(Boolean).join(" ");
    return `${what ? `    /** ${what} */\n` : ""}    ${p.name}${p.required ? "" : "?"}: ${typeOf(p.schema)};\n`;
  });
  const optional = rest.some((p) => p.required) ? "" : "?";
  const object = fields.length ? `{\n${fields.join("")}  }` : "Record<string, never>";
  const before = first ? `${first.name}${first.required ? "" : "?"}: ${typeOf(first.schema)}, ` : "";
  types += `  /** ${method.summary} */\n  ${nameOf(method.name)}(${before}params${optional}: ${object}): Promise<Result>;\n`;
}
code += "}\n";
types += "}\n";

const files = { "src/methods.js": code, "methods.d.ts": types };
const check = process.argv.includes("--check");
for (const [path, text] of Object.entries(files)) {
  if (!check) fs.writeFileSync(here(path), text);
  else if (!fs.existsSync(here(path)) || fs.readFileSync(here(path), "utf8") !== text) process.exitCode = 1;
}
