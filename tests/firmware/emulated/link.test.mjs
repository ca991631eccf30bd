// SPDX-License-Identifier: MIT
// The linker script refuses what start-up does not do.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const script = fileURLToPath(new URL('../../../firmware/board.ld', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'hedgehog-link-'));
after(() => rmSync(folder, { recursive: true }));

/** The linker's messages for a program of this text. */
function linked(text) {
  const { status, stderr } = spawnSync('arm-none-eabi-g++', ['-std=c++20', '-mcpu=cortex-m0plus', '-mthumb', '-ffreestanding', '-fno-threadsafe-statics',
    '-nostdlib', '-Wl,--gc-sections', `-Wl,-T,${script}`, '-x', 'c++', '-', '-o', join(folder, 'a.elf')], { encoding: 'utf8', input: text });
  return { status, stderr };
}
const kStart = 'extern "C" void reset_handler() { for (;;) {} }\n[[gnu::section(".start.vectors"), gnu::used]] void (*const first)() = reset_handler;\n';

test('an object with a constructor, which nobody would run, is an error of the linker; a constinit one is none', () => {
  const text = (kind) => `${kStart}extern "C" int twice(int); struct Object { constexpr Object(int n) : n(n) {} int n; };
    [[gnu::used]] ${kind}\nextern "C" int twice(int n) { return 2 * n; }`;
  assert.deepEqual(linked(text('constinit Object object{2};')).status, 0);
  const refused = linked(text('Object object{twice(2)};'));
  assert.notEqual(refused.status, 0);
  assert.match(refused.stderr, /no constructor is run here/);
});
