// SPDX-License-Identifier: MIT
// Runs tests as separate programs, and evaluates which of them failed: a test that does not end gives no result.
import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const reporter = fileURLToPath(new URL('outcomes.mjs', import.meta.url));
const nodeTest = fileURLToPath(new URL('../../node_test.sh', import.meta.url));
/** A failed assertion or an exception, in the test itself, in a part of it or in a hook. */
const kFound = ['testCodeFailure', 'subtestsFailed', 'hookFailed'];
/** Exit codes of timeout(1), also after a SIGKILL. */
const kTimedOut = [124, 137];
const literally = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

/** The output of a program, and its exit code. */
export const run = (program, args, env = {}) => new Promise((done) => {
  const child = spawn(program, args, { env: { ...process.env, ...env } });
  let output = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => { output += data; });
  child.on('close', (code) => done({ code, output }));
});

/** Runs the tests of `files` whose name contains `word`. {red: names of those that failed, problem: why the run is invalid; empty: it is
 *  valid}. */
export async function runTests(files, word, { timeoutMs, env = {} }) {
  // Inside another test, Node would skip these tests.
  const ended = await run(nodeTest, [timeoutMs, `--test-reporter=${reporter}`, `--test-name-pattern=${literally(word)}`, ...files],
    { ...env, NODE_TEST_CONTEXT: undefined, HEDGEHOG_NODE_TESTS: '1' });
  const outcomes = ended.output.split('\n').filter((line) => line.startsWith('{"name"')).map((line) => JSON.parse(line));
  const matching = outcomes.filter(({ name }) => name.includes(word));
  // For a test that does not end, Node reports its file.
  const unfinished = outcomes.filter(({ failure }) => failure && !kFound.includes(failure));
  const red = matching.filter(({ failure }) => kFound.includes(failure)).map(({ name }) => name);
  let problem = '';
  if (kTimedOut.includes(ended.code)) problem = `did not end: ${word}: timed out`;
  else if (unfinished.length > 0) problem = `did not end: ${unfinished.map(({ name, message }) => `${name}: ${message}`).join('; ')}`;
  else if (red.length === 0 && ended.code !== 0) problem = `failed otherwise\n${ended.output}`;
  else if (matching.length === 0) problem = 'there is no such test';
  return { red, problem };
}
