// SPDX-License-Identifier: MIT
// The bill of materials of a board, from its netlist.

const kOrder = ["PICO", "G2_18V17", "INA240A2", "INA240A3", "MCP3208", "REF3033", "BTS50010", "LVC1G07", "LM2940", "SHUNT", "TVS", "FUSE", "POLYFUSE"];

function value(part) {
  if (part.valueText === undefined) return "";
  const unit = { resistor: "Ohm", trimmer: "Ohm", shunt: "Ohm", capacitor: "F", fuse: "A", polyfuse: "A" }[part.kind] ?? "";
  const tolerance = part.tol === undefined ? "" : ` ${+(100 * part.tol).toFixed(2)} %`;
  const rating = part.kind === "capacitor" ? ` ${part.volts} V` : part.power === undefined ? "" : ` ${part.power} W`;
  const [, number, prefix] = /^([\d.]+)(.?)$/.exec(part.valueText);
  return `${number} ${prefix}${unit}${tolerance}${rating}`;
}

/** Rows {count, refs, value, description, order}: equal parts together. */
export function bom(board) {
  const rows = new Map();
  for (const part of board.parts.values()) {
    const row = { type: part.type, refs: [], value: value(part), description: part.description, order: part.order ?? "" };
    const key = `${row.type}|${row.value}|${row.order}`;
    if (!rows.has(key)) rows.set(key, row);
    rows.get(key).refs.push(part.ref);
  }
  const rank = ({ type }) => (kOrder.includes(type) ? kOrder.indexOf(type) : kOrder.length + (type === "R" || type === "C" ? 1 : 0));
  return [...rows.values()].sort((a, b) => rank(a) - rank(b) || a.type.localeCompare(b.type) || a.value.localeCompare(b.value))
    .map((row) => ({ count: row.refs.length, ...row, refs: row.refs.join(" ") }));
}

const quoted = (text) => (/[",]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

export function bomCsv(board) {
  const rows = bom(board).map(({ count, refs, description, value: text, order }) =>
    [String(count), refs, description, text, order].map(quoted).join(","));
  return ["count,parts,what,value,order", ...rows].join("\n") + "\n";
}
