// SPDX-License-Identifier: MIT
// A request as text.

/** The parameters that are given: neither undefined nor null. */
export function given(params) {
  return Object.fromEntries(Object.entries(params).filter(([, value]) => value !== undefined && value !== null));
}

/** JSON.stringify alone writes null. */
function finite(_, value) {
  if (typeof value === "number" && !Number.isFinite(value)) throw new TypeError(`${value} is not a finite number`);
  return value;
}

function valueText(method, name, value) {
  try {
    return JSON.stringify(value, finite);
  } catch (error) {
    throw new TypeError(`${method}: ${name}: ${error.message}`, { cause: error });
  }
}

/** Without `id`: not answered. Throws TypeError, which names the parameter, for what JSON does not have: a BigInt, a cycle, NaN. */
export function requestText({ id, method }, params) {
  const fields = [];
  for (const [name, value] of Object.entries(given(params))) {
    const text = valueText(method, name, value);
    // Functions and symbols have none.
    if (text !== undefined) fields.push(`${JSON.stringify(name)}:${text}`);
  }
  const head = JSON.stringify({ jsonrpc: "2.0", id, method });
  return fields.length > 0 ? `${head.slice(0, -1)},"params":{${fields.join()}}}` : head;
}
