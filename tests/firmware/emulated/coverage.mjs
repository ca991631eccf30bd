// SPDX-License-Identifier: MIT
// Which source lines of the image the emulated processor has executed. coverage.mjs ELF FOLDER: the tests' output there
// (HEDGEHOG_FIRMWARE_COVERAGE), by the compiler's line table. Prints each file's share and the lines that were never executed. Exit: 0, 1
// less than kMinPercent.
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

/** The coverage of the tests; may only be raised. */
const kMinPercent = 97.9;

const [elf, folder] = process.argv.slice(2);
const executed = new Set();
for (const name of readdirSync(folder)) for (const address of JSON.parse(readFileSync(join(folder, name)))) executed.add(address);

/** "firmware/pins.cpp" -> line -> whether it was executed. */
const files = new Map();
let file = '';
const table = execFileSync('arm-none-eabi-objdump', ['--dwarf=decodedline', elf], { maxBuffer: 1 << 26, encoding: 'utf8' });
for (const line of table.split('\n')) {
  const heading = line.match(/^(?:CU: )?(\S+):(?:\[\+\+\])?$/);
  if (heading) file = heading[1].replace(/^\.\//, '');
  const row = line.match(/^\S+\s+(\d+)\s+0x([0-9a-f]+)/);
  if (!row || !/^(firmware|daemon\/device\/board_core)\//.test(file)) continue;
  const address = parseInt(row[2], 16);
  if (address < 0x10000000) continue; // removed by the linker
  if (!files.has(file)) files.set(file, new Map());
  const lines = files.get(file);
  lines.set(Number(row[1]), (lines.get(Number(row[1])) ?? false) || executed.has(address));
}

let all = 0;
let covered = 0;
for (const [name, lines] of [...files].sort()) {
  const missed = [...lines].filter(([, was]) => !was).map(([line]) => line).sort((a, b) => a - b);
  all += lines.size;
  covered += lines.size - missed.length;
  console.log(`${name}: ${lines.size - missed.length} of ${lines.size} lines${missed.length > 0 ? `; not ${missed.join(', ')}` : ''}`);
}
const percent = (100 * covered) / all;
console.log(`${percent.toFixed(1)} % of the image's own lines were executed`);
if (!(percent >= kMinPercent)) {
  console.error(`coverage.mjs: less than ${kMinPercent} %`);
  process.exitCode = 1;
}
