// SPDX-License-Identifier: MIT
// The tests named in the column "on the firmware" of the safety table exist.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';

const here = new URL('.', import.meta.url);
const kColumn = 6;

test('each test that the safety table names is here', () => {
  const page = readFileSync(new URL('../../../daemon/safety.md', here), 'utf8');
  const table = page.slice(page.indexOf('| hazard | guard |')).split('\n\n')[0].split('\n').slice(2);
  // Names of tests for each winding contain its number.
  const sources = readdirSync(here).filter((name) => name.endsWith('.test.mjs') && !name.startsWith('safety_table'))
    .map((name) => readFileSync(new URL(name, here), 'utf8').replaceAll('${k}', '0')).join('\n');
  const named = table.flatMap((row) => [...row.split(' | ').at(-1).matchAll(/“([^”]+)”/g)].map(([, name]) => name));
  assert.ok(table.every((row) => row.split(' | ').length === kColumn), 'each row has the column');
  assert.ok(named.length >= 20, `${named.length} tests`);
  assert.deepEqual(named.filter((name) => !new RegExp(`(test\\(|what: ).*${name.replaceAll('.', '\\.')}`).test(sources)), []);
});
