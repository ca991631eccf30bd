#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Writes src/methods.js, src/error_codes.js, methods.d.ts and messages.d.ts from the OpenRPC document. With --check nothing is
// written; exit 1 says that a file is not what the document gives.
import fs from "node:fs";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const document = JSON.parse(fs.readFileSync(here("../../protocol/schema/openrpc.json"), "utf8"));
const { schemas, errors } = document.components;

// Written by hand in src/ball.js; they can be called by name.
const OWN = ["hello", "events.subscribe", "events.unsubscribe", "telemetry.subscribe", "telemetry.unsubscribe"];
// What a newcomer writes first may stand without its name.
const FIRST = ["direction", "axis", "pattern"];
// Names that the language or the page has already.
const RENAMED = { Event: "BallEvent" };
const HEAD = "// SPDX-License-Identifier: MIT\n// Written by generate.mjs from protocol/schema/openrpc.json.\n";

const camel = (words) => words.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
const pascal = (words) => camel(`_${words.replace(".", "_")}`);
function nameOf(method) {
  const [space, rest] = method.split(".");
  if (!rest) return space;
  return camel(space === "effect" || space === "device" ? rest : `${space}_${rest}`);
}

const quoted = (values) => values.map((value) => JSON.stringify(value)).join(" | ");
const resultName = (name) => RENAMED[name] ?? name;

function typeOf(schema, indent = "") {
  if (schema.enum) return quoted(schema.enum);
  if (schema.$ref) return resultName(schema.$ref.split("/").pop());
  if (schema.anyOf) return schema.anyOf.map((one) => typeOf(one, indent)).join(" | ");
  // Words of which a later daemon may have more.
  if (schema.examples && schema.type === "string") return `${quoted(schema.examples)} | (string & {})`;
  if (schema.type === "array") {
    const item = typeOf(schema.items ?? {}, indent);
    if (schema.minItems === 3 && schema.maxItems === 3) return `[${Array(3).fill(item).join(", ")}]`;
    return `Array<${item}>`;
  }
  if (schema.type === "object" && schema.properties) return `{\n${fields(schema, `${indent}  `)}${indent}}`;
  return { number: "number", integer: "number", string: "string", boolean: "boolean", object: "object", null: "null" }[
    schema.type] ?? "unknown";
}

function bounds(schema) {
  if (schema.minimum !== undefined && schema.maximum !== undefined) return `${schema.minimum} to ${schema.maximum}`;
  return schema.minimum !== undefined ? `at least ${schema.minimum}` : "";
}

function field(name, schema, required, indent, described) {
  const what = described ? [schema.description, bounds(schema)].filter(Boolean).join(" ") : schema.description;
  const comment = what ? `${indent}/** ${what} */\n` : "";
  return `${comment}${indent}${name}${required ? "" : "?"}: ${typeOf(schema, indent)};\n`;
}

function fields(schema, indent) {
  const required = schema.required ?? [];
  return Object.entries(schema.properties).map(([name, one]) => field(name, one, required.includes(name), indent, false)).join("");
}

const known = document.methods;
const methods = known.filter((method) => !OWN.includes(method.name));

function methodsCode() {
  let code = `${HEAD}\n/** The daemon's methods; parameters by name, as protocol/README.md has them. */\nexport class Methods {\n`;
  for (const method of methods) {
    const first = firstOf(method);
    const args = first ? `${first.name}, params` : "params";
    const passed = first ? `{ ${first.name}, ...params }` : "params";
    code += `  /** ${method.summary} */\n  ${nameOf(method.name)}(${args}) {\n    return this.call("${method.name}", ${passed});\n  }\n`;
  }
  return `${code}}\n`;
}

function firstOf(method) {
  return FIRST.includes(method.params[0]?.name) ? method.params[0] : undefined;
}

function paramsOf(method) {
  const name = `${pascal(method.name)}Params`;
  const lines = method.params.map((one) => field(one.name, one.schema, one.required, "  ", true)).join("");
  return lines ? `\nexport interface ${name} {\n${lines}}\n` : `\nexport type ${name} = Record<string, never>;\n`;
}

function methodsTypes() {
  const results = methods.map((method) => typeOf(method.result.schema));
  const params = methods.map((method) => `${pascal(method.name)}Params`);
  const names = [...new Set(["Direction", ...results, ...params])].sort();
  let types = `${HEAD}import type {\n${names.map((name) => `  ${name},\n`).join("")}} from "./messages.js";\n\nexport declare class Methods {\n`;
  for (const method of methods) {
    const first = firstOf(method);
    const params = `${pascal(method.name)}Params`;
    const rest = method.params.filter((one) => one !== first);
    const optional = rest.some((one) => one.required) ? "" : "?";
    const object = first ? `Omit<${params}, "${first.name}">` : params;
    const before = first ? `${first.name}${first.required ? "" : "?"}: ${typeOf(first.schema)}, ` : "";
    types += `  /** ${method.summary} */\n`;
    types += `  ${nameOf(method.name)}(${before}params${optional}: ${object}): Promise<${typeOf(method.result.schema)}>;\n`;
  }
  return `${types}}\n`;
}

function messagesTypes() {
  let types = `${HEAD}// Results, events, errors and parameters. A later daemon may send more than they name.\n`;
  for (const [name, schema] of Object.entries(schemas)) {
    if (name === "Error") {
      types += `\n/** \`data\` of a refusal. */\nexport interface ErrorData {\n${fields(schema.properties.data, "  ")}}\n`;
    } else if (schema.properties) {
      types += `\nexport interface ${resultName(name)} {\n${fields(schema, "  ")}}\n`;
    } else {
      types += `\n/** ${name === "Direction" ? "Where the pins push out." : name} */\nexport type ${name} = ${typeOf(schema)};\n`;
    }
  }
  types += `\n/** The types of events. */\nexport type EventType = ${quoted(schemas.Event.properties.type.examples)};\n`;
  types += "\n/** Codes of refusals, by name. */\nexport declare const ErrorCode: {\n";
  for (const [name, { code, message }] of Object.entries(errors)) types += `  /** ${message} */\n  readonly ${name}: ${code};\n`;
  types += "};\nexport type ErrorName = keyof typeof ErrorCode;\n";
  types += known.map(paramsOf).join("");
  types += "\n/** Parameters and result of each method, for `ball.call`. */\nexport interface MethodTypes {\n";
  for (const method of known)
    types += `  "${method.name}": { params: ${pascal(method.name)}Params; result: ${typeOf(method.result.schema)} };\n`;
  return `${types}}\n`;
}

function errorCodes() {
  const lines = Object.entries(errors).map(([name, { code, message }]) => `  /** ${message} */\n  ${name}: ${code},\n`);
  return `${HEAD}\n/** Codes of RequestError, by name. */\nexport const ErrorCode = Object.freeze({\n${lines.join("")}});\n`;
}

const files = {
  "src/methods.js": methodsCode(),
  "src/error_codes.js": errorCodes(),
  "methods.d.ts": methodsTypes(),
  "messages.d.ts": messagesTypes(),
};
const check = process.argv.includes("--check");
for (const [path, text] of Object.entries(files)) {
  if (!check) fs.writeFileSync(here(path), text);
  else if (!fs.existsSync(here(path)) || fs.readFileSync(here(path), "utf8") !== text) process.exitCode = 1;
}
