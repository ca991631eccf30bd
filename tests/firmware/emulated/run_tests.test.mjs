// SPDX-License-Identifier: MIT
// What counts as a failing test when a guard is removed.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { runTests } from './run_tests.mjs';

const kExample = `
import { test } from 'node:test';
test('good one', () => {});
test('bad one', () => { throw new Error('found'); });
test('endless one (of two)', () => new Promise(() => setInterval(() => {}, 1000)));
test('endless two, busy', () => { for (;;); });
`;

async function outcomeOf(word, timeoutMs = 600_000) {
  const folder = mkdtempSync(join(tmpdir(), 'hedgehog-outcomes-'));
  try {
    writeFileSync(join(folder, 'example.test.mjs'), kExample);
    return await runTests([join(folder, 'example.test.mjs')], word, { timeoutMs });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a test that fails is red', async () => assert.deepEqual(await outcomeOf('bad one'), { red: ['bad one'], problem: '' }));

test('a test that passes is not', async () => assert.deepEqual(await outcomeOf('good one'), { red: [], problem: '' }));

for (const word of ['endless one (of two)', 'endless two'])
  test(`a time-out is no red test but an error: ${word}`, async () => {
    const { red, problem } = await outcomeOf(word, 2000);
    assert.deepEqual(red, []);
    assert.match(problem, /^did not end: .*timed out/);
  });

test('a name that no test has is an error', async () => {
  assert.deepEqual(await outcomeOf('no such'), { red: [], problem: 'there is no such test' });
});
