// SPDX-License-Identifier: MIT
// Each document of JSONTestSuite parsed by the readers of JSON files: no program crashes on an edited file.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { before, test } from 'node:test';
import { text } from 'node:stream/consumers';

import { documents, is_refused } from './json_test_suite.mjs';

/** In the order of kReaders in json_readers.cpp. */
const kReaders = ['wire', 'saved_file', 'written_file', 'configuration', 'imported_file'];

/** Documents that are JSON except for their comments. */
const kCommented = [
  'n_object_trailing_comment', 'n_object_trailing_comment_slash_open', 'n_structure_object_with_comment',
];
/** Documents that are JSON except for a trailing comma. */
const kTrailingComma = [
  'n_array_extra_comma', 'n_array_number_and_comma', 'n_object_trailing_comma',
  'n_object_lone_continuation_byte_in_key_and_trailing_comma', // with U+FFFD, as in the package
];
/** Files written by programs and experimenters may repeat a name, whose last value counts, and be nested deeply. */
const kBeyondTheWire = ['y_object_duplicated_key', 'y_object_duplicated_key_and_value', 'i_structure_500_nested_arrays'];
/** The configuration is at most 16 levels deep; its keys are checked later. */
const kBeyondTheConfiguration = ['i_structure_500_nested_arrays'];

let outcomes;
before(async () => {
  const program = spawn(process.env.HEDGEHOG_JSON_READERS, { stdio: ['pipe', 'pipe', 'inherit'] });
  const ended = once(program, 'exit');
  const out = text(program.stdout);
  program.stdin.end(documents.map(({ bytes }) => `${bytes.toString('hex')}\n`).join(''));
  outcomes = (await out).trimEnd().split('\n');
  assert.deepEqual(await ended, [0, null]);
  assert.equal(outcomes.length, documents.length);
});

const read_by = (reader) => documents.filter((_, i) => outcomes[i][kReaders.indexOf(reader)] === 'r').map(({ name }) => name);
const readable = (also = []) => documents.filter((document) => !is_refused(document) || also.includes(document.name)).map(({ name }) => name);

test('texts of the wire are accepted as the daemon accepts them', () => {
  assert.deepEqual(read_by('wire'), readable());
});

test('files that the programs write may be nested deeper', () => {
  assert.deepEqual(read_by('saved_file'), readable(kBeyondTheWire));
});

test('files that people write may have comments too', () => {
  assert.deepEqual(read_by('written_file'), readable([...kBeyondTheWire, ...kCommented]));
});

test('so may the configuration', () => {
  const also = [...kBeyondTheWire, ...kCommented].filter((name) => !kBeyondTheConfiguration.includes(name));
  assert.deepEqual(read_by('configuration'), readable(also));
});

test('imported patterns may have a comma behind a last item', () => {
  assert.deepEqual(read_by('imported_file'), readable(kTrailingComma));
});
