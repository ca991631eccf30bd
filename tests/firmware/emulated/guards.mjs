// SPDX-License-Identifier: MIT
// Removes each guard of guards.txt from the image, one at a time, and requires a failing test. guards.mjs FIRMWARE_IMAGE [--third] [WORD]:
// only guards whose name or hazard contains WORD; with --third every third one, selected by the day of the month. JOBS: guards at a time.
// Exit: 0 all guards had a failing test, 1 one had none, 64 usage or no such guard, 65 a guard is not in the listed file, cannot be built,
// or a test of it does not end. run.sh has the environment (HEDGEHOG_FIRMWARE_PLANT, HEDGEHOG_NODE_MODULES).
import { cpSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { run, runTests } from './run_tests.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const top = resolve(here, '../../..');
const third = process.argv.includes('--third');
const [image, word = ''] = process.argv.slice(2).filter((argument) => argument !== '--third');

function readGuards() {
  const guards = [];
  let hazard = '';
  for (const line of readFileSync(join(here, 'guards.txt'), 'utf8').split('\n')) {
    const [, key, rest = ''] = line.match(/^(\w+)(?: (.*))?$/) ?? [];
    if (key === 'hazard') hazard = rest;
    else if (key === 'guard') guards.push({ hazard, name: rest, red: [] });
    else if (key === 'red') guards.at(-1).red.push(rest);
    else if (key) guards.at(-1)[key] = rest;
  }
  return guards;
}

/** Copies the sources that build.sh needs, without the guard. False: its text does not occur exactly once. */
function copyWithout({ file, cut, put = '' }, folder) {
  for (const path of ['firmware', 'daemon/device/board_core', 'tests/firmware/worst_stack.awk'])
    cpSync(join(top, path), join(folder, path), { recursive: true });
  const path = join(folder, file);
  const parts = readFileSync(path, 'utf8').split(cut);
  if (parts.length !== 2) return false;
  writeFileSync(path, parts.join(put));
  // Without the guard, variables may be unused.
  const build = join(folder, 'firmware/build.sh');
  writeFileSync(build, readFileSync(build, 'utf8').replace(' -Werror ', ' '));
  return true;
}

const kTests = readdirSync(here).filter((name) => name.endsWith('.test.mjs')).map((name) => join(here, name));
const kTimeoutMs = 120_000;

/** 0, 1 or 65, as the program's exit code. */
async function testGuard(guard) {
  const folder = mkdtempSync(join(tmpdir(), 'hedgehog-guard-'));
  try {
    if (!copyWithout(guard, folder)) {
      console.error(`BROKEN    ${guard.name}: not once in ${guard.file}: ${guard.cut}`);
      return 65;
    }
    const built = await run(join(folder, 'firmware/build.sh'), [join(folder, 'out'), resolve(image)]);
    if (built.code !== 0) {
      console.error(`BROKEN    ${guard.name}: does not build\n${built.output}`);
      return 65;
    }
    const blind = [];
    const failed = new Set();
    const env = { HEDGEHOG_FIRMWARE_ELF: join(folder, 'out/hedgehog-board.elf'), HEDGEHOG_FIRMWARE_COVERAGE: '' };
    for (const word of guard.red) {
      const { red, problem } = await runTests(kTests, word, { timeoutMs: kTimeoutMs, env });
      if (problem) {
        console.error(`BROKEN    ${guard.name}: ${word}: ${problem}`);
        return 65;
      }
      if (red.length === 0) blind.push(word);
      red.forEach((name) => failed.add(name));
    }
    console.log(blind.length > 0 ? `SURVIVED  ${guard.name}: ${blind.join('; ')}`
      : `red ${String(failed.size).padStart(3)}   ${guard.name}: ${[...failed].join('; ').slice(0, 100)}`);
    return blind.length > 0 ? 1 : 0;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const guards = readGuards().filter(({ name, hazard }, at) =>
  (name.includes(word) || hazard.includes(word)) && (!third || at % 3 === new Date().getDate() % 3));
if (!image || guards.length === 0) {
  console.error(image ? `guards.mjs: no guard has "${word}"` : 'guards.mjs FIRMWARE_IMAGE [--third] [WORD]');
  process.exitCode = 64;
} else {
  let next = 0;
  const worker = async () => {
    while (next < guards.length) process.exitCode = Math.max(process.exitCode ?? 0, await testGuard(guards[next++]));
  };
  await Promise.all(Array.from({ length: Number(process.env.JOBS ?? 2) }, worker));
  if (process.exitCode === 0) console.log(`${guards.length} guards of the image, each seen red`);
}
