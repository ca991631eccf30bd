// SPDX-License-Identifier: MIT
// Reads a board's netlist and the library of its parts; the format stands in netlist.md beside this file.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const kBoardFolder = dirname(fileURLToPath(import.meta.url));

const kPrefix = { M: 1e6, k: 1e3, m: 1e-3, u: 1e-6, n: 1e-9, p: 1e-12 };

/** "4.7k" is 4700, "100n" 1e-7. NaN: not a quantity. */
export function quantity(text) {
  const match = /^(-?\d+(?:\.\d+)?)([MkmunpR]?)$/.exec(text);
  return match ? Number(match[1]) * (kPrefix[match[2]] ?? 1) : NaN;
}

/** "0..3.3V" as {min, max}. */
function range(text) {
  const match = /^(-?[\d.]+)\.\.(-?[\d.]+?)(V|A|C)?$/.exec(text);
  return match ? { min: Number(match[1]), max: Number(match[2]), unit: match[3] ?? "V" } : null;
}

/** "down:50k..80k", "up:10k..100k@5" as {to, min, max, volts}. */
function pull(text) {
  const match = /^(up|down):([^.]+)\.\.([^@]+)(?:@(.+))?$/.exec(text);
  return match && { to: match[1], min: quantity(match[2]), max: quantity(match[3]), volts: Number(match[4] ?? 0) };
}

/** Words of a line; "..." is one of them, also behind a key. */
const words = (line) => (line.replace(/^#.*|\s#.*/, "").match(/(?:[^\s"]+="[^"]*"|"[^"]*"|[^\s"]+)/g) ?? []);
const unquoted = (text) => text.replace(/^"|"$/g, "");

/** key=value; quantities become numbers, percent a share. */
function attributes(tokens) {
  const found = {};
  for (const token of tokens) {
    const at = token.indexOf("=");
    const key = token.slice(0, at);
    const text = unquoted(token.slice(at + 1));
    const number = text.endsWith("%") ? Number(text.slice(0, -1)) / 100 : quantity(text);
    found[key] = Number.isNaN(number) ? text : number;
  }
  return found;
}

/** Part types by name: {name, description, pins: Map of name to {kind, ...}, ...}. */
export function parseParts(text) {
  const types = new Map();
  let type = null;
  for (const line of text.split("\n")) {
    const [head, name, ...rest] = words(line);
    if (head === "type") {
      type = { description: unquoted(rest[0]), ...attributes(rest.slice(1)), name, pins: new Map() };
      types.set(name, type);
    } else if (head === "pin") {
      const pin = { kind: rest[0], ...attributes(rest.slice(1)) };
      if (pin.v !== undefined) pin.v = range(String(pin.v));
      for (const key of ["reset", "pull"]) if (pin[key]) pin[key] = pull(pin[key]);
      type.pins.set(name, pin);
    }
  }
  return types;
}

function parsePart(board, types, tokens, problem) {
  const [ref, typeName, ...rest] = tokens;
  const type = types.get(typeName);
  if (!type) return problem(`${ref}: no part type ${typeName}`);
  if (board.parts.has(ref)) return problem(`${ref} stands twice`);
  const colon = rest.indexOf(":");
  const before = rest.slice(0, colon);
  const part = { ...type, ref, type: typeName, pins: new Map(), note: "" };
  if (before[0] && !before[0].includes("=")) {
    part.valueText = before[0];
    part.value = quantity(before.shift());
  }
  Object.assign(part, attributes(before));
  const connect = (pin, net) => {
    if (!type.pins.has(pin)) problem(`${ref} (${typeName}) has no pin ${pin}`);
    else if (part.pins.has(pin)) problem(`${ref}.${pin} is connected twice`);
    else part.pins.set(pin, net);
  };
  for (const token of rest.slice(colon + 1)) {
    const [key, value] = token.split("=");
    if (token.startsWith('"')) part.note = unquoted(token);
    else if (key === "unused") for (const pin of value.split(",")) connect(pin, null);
    else connect(key, value);
  }
  board.parts.set(ref, part);
  return undefined;
}

function parseLine(board, types, line, problem, include) {
  const tokens = words(line);
  if (tokens.length === 0) return;
  const [head, ...rest] = tokens;
  const addNet = (name, span, amps) => {
    if (board.nets.has(name)) problem(`net ${name} stands twice`);
    board.nets.set(name, { name, min: span?.min ?? NaN, max: span?.max ?? NaN, amps });
  };
  if (head === "board") Object.assign(board, { name: rest[0], title: unquoted(rest[1]) });
  else if (head === "include") include(rest[0]);
  else if (head === "net") addNet(rest[0], range(rest[1]), rest[2] ? parseFloat(rest[2]) : undefined);
  else if (head === "signals") for (const name of rest.slice(1)) addNet(name, range(rest[0].replace(":", "")));
  else if (head === "safe") board.safe.push({ net: rest[0], level: rest[1], states: rest.slice(2) });
  else if (head === "free") board.free.push(rest[0]);
  else if (head === "drive") board.drives.set(rest[0], parseFloat(rest[1]));
  else if (head === "usb") board.usbMa = parseFloat(rest[0]);
  else if (head === "way") board.way = { from: rest[0], to: rest[1], through: rest.slice(2) };
  else if (head === "winding") {
    const [henry, ohm, amps, chopAmps] = rest.map((text) => parseFloat(text));
    board.winding = { henry: henry * 1e-3, ohm, amps, chopAmps };
  } else if (head === "measure") board.measures.push({ name: rest[0], at: rest[1], ...range(rest[2]) });
  else parsePart(board, types, tokens, problem);
}

/** The board of a text. `files` gives the text of an included one. What is wrong with its form is in `problems`. */
export function parseBoard(text, types, files = () => "") {
  const board = { name: "", title: "", parts: new Map(), nets: new Map(), safe: [], free: [], drives: new Map(), measures: [], problems: [] };
  const read = (source, where) => source.split("\n").forEach((line, i) => {
    const problem = (message) => board.problems.push(`${where}:${i + 1}: ${message}`);
    parseLine(board, types, line, problem, (name) => read(files(name), name));
  });
  read(text, "board");
  return board;
}

const file = (name) => readFileSync(join(kBoardFolder, name), "utf8");
export const readParts = () => parseParts(file("parts.txt"));
/** `name`: "reference" or "thesis". */
export const readBoard = (name) => parseBoard(file(`${name}.net`), readParts(), file);

/** Every pin on `net`: {part, name, ...pin}. */
export function pinsOn(board, types, net) {
  const found = [];
  for (const part of board.parts.values())
    for (const [name, on] of part.pins)
      if (on === net) found.push({ part, name, ...types.get(part.type).pins.get(name) });
  return found;
}

/** The resistors on `net`, with what is at their other end. */
export function resistorsOn(board, net) {
  const found = [];
  for (const part of board.parts.values()) {
    if (part.kind !== "resistor") continue;
    const [one, other] = [part.pins.get("1"), part.pins.get("2")];
    if (one === net || other === net) found.push({ part, other: one === net ? other : one });
  }
  return found;
}

/** Farad between `net` and ground, by nominal value. */
export function capacitorsOn(board, net) {
  return [...board.parts.values()].filter((part) =>
    part.kind === "capacitor" && [...part.pins.values()].includes(net) && [...part.pins.values()].includes("GND"));
}
