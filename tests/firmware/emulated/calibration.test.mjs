// SPDX-License-Identifier: MIT
// An image with the calibration values of one board (bring-up.md, step 6): its readings through electronics with these values
// match the currents, and values out of tolerance are compile errors. HEDGEHOG_FIRMWARE_CALIBRATION: of the image HEDGEHOG_FIRMWARE_ELF
// (make firmware-calibrated); otherwise calibration_example.h, for which an image is built here.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Board, Driver } from './board.mjs';
import { kMode } from './frames.mjs';

const top = fileURLToPath(new URL('../../..', import.meta.url));
const own = process.env.HEDGEHOG_FIRMWARE_CALIBRATION;
const file = own ?? fileURLToPath(new URL('calibration_example.h', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'hedgehog-calibration-'));
after(() => rmSync(folder, { recursive: true }));

const kDesign = { zeroUv: 1_650_000, uvPerA: 50_000, shuntUvPerA: 100_000 };
/** In the order of SimulatorErrorKind. */
const kErrorKinds = { gain: 0, offset: 1 };
const kDuty = [0.19, -0.19, 0.15];
/** A step of the converter is 16 mA; the noise of 0.04 A is averaged. */
const kMaxErrorMa = 25;
const kMean = 100;
const kSourceReadings = 200;

/** The values in a calibration header. */
function figures(text) {
  const list = (name) => new RegExp(`${name}(?:\\[\\])? = \\{?([\\d', ]+)`).exec(text)[1].replaceAll("'", '').split(',').map(Number);
  return { zeroUv: list('kCurrentZeroUv'), uvPerA: list('kCurrentUvPerA'), shuntUvPerA: list('kShuntUvPerA')[0] };
}
const calibration = figures(readFileSync(file, 'utf8'));

function calibratedImage() {
  if (own) return process.env.HEDGEHOG_FIRMWARE_ELF;
  execFileSync(join(top, 'firmware/build.sh'), [folder, join(process.env.HEDGEHOG_PROGRAMS, 'firmware/firmware_image'), file]);
  return join(folder, 'hedgehog-board.elf');
}

/** Mean reported and true currents of each winding, at rest and driven, mA, through the electronics of `file`. */
function readings(elf) {
  const board = new Board(elf);
  try {
    const driver = new Driver(board);
    const errors = calibration.uvPerA.flatMap((uvPerA, k) => [
      kErrorKinds.gain, k, uvPerA / kDesign.uvPerA, kErrorKinds.offset, k, (calibration.zeroUv[k] - kDesign.zeroUv) / kDesign.uvPerA,
    ]);
    board.plant.command(`error ${errors.join(' ')}`);
    const mean = () => {
      const sums = { measured: [0, 0, 0], flows: [0, 0, 0] };
      for (let i = 0; i < kMean; ++i) {
        board.run(1);
        for (let k = 0; k < 3; ++k) {
          sums.measured[k] += driver.last.currentMa[k] / kMean;
          sums.flows[k] += board.readings.trueMa[k] / kMean;
        }
      }
      return sums;
    };
    driver.enumerate();
    const rest = mean();
    driver.drive(kDuty, 100);
    const driven = mean();
    assert.equal(driver.last.mode, kMode.driving, `faults ${driver.last.faults}`);
    return { rest, driven };
  } finally {
    board.close();
  }
}

const worst = ({ measured, flows }) => Math.max(...measured.map((one, k) => Math.abs(one - flows[k])));

test('a calibrated image reads what flows, at rest and at 5 A, in each winding', () => {
  const { rest, driven } = readings(calibratedImage());
  assert.ok(Math.min(...driven.flows.map(Math.abs)) > 3000, `${driven.flows} mA`);
  assert.ok(worst(rest) < kMaxErrorMa, `${rest.measured} for ${rest.flows} mA`);
  assert.ok(worst(driven) < kMaxErrorMa, `${driven.measured} for ${driven.flows} mA`);
});

test('the figures that step 6 finds by telemetry, with the image of the design, are those of the electronics', () => {
  const board = new Board(process.env.HEDGEHOG_FIRMWARE_ELF);
  try {
    const driver = new Driver(board);
    driver.enumerate();
    /** Means of the telemetry while a source drives `amps` through the shunt of winding `k`: an offset of the reading, the bridges sleep. */
    const line = (k, amps) => {
      const errors = [0, 1, 2].flatMap((one) => {
        const zeroA = (calibration.zeroUv[one] - kDesign.zeroUv) / kDesign.uvPerA;
        return [kErrorKinds.offset, one, zeroA + (one === k ? amps * calibration.uvPerA[one] / kDesign.uvPerA : 0)];
      });
      board.plant.command(`error ${errors.join(' ')}`);
      board.run(5);
      const sums = [0, 0, 0];
      for (let i = 0; i < kSourceReadings; ++i) {
        board.run(1);
        driver.last.currentMa.forEach((ma, one) => { sums[one] += ma / 1000 / kSourceReadings; });
      }
      return sums;
    };
    const lines = [0, 1, 2].map((k) => ({ plus: line(k, 5), minus: line(k, -5) }));
    for (let k = 0; k < 3; ++k) {
      const others = lines.filter((_, i) => i !== k).flatMap(({ plus, minus }) => [plus[k], minus[k]]);
      const zeroUv = 1_650_000 + 50_000 * others.reduce((sum, one) => sum + one, 0) / 4;
      const uvPerA = 50_000 * (lines[k].plus[k] - lines[k].minus[k]) / 10;
      assert.ok(Math.abs(zeroUv - calibration.zeroUv[k]) < 400, `winding ${k}: zero ${zeroUv} for ${calibration.zeroUv[k]} uV`);
      assert.ok(Math.abs(uvPerA / calibration.uvPerA[k] - 1) < 0.003, `winding ${k}: ${uvPerA} for ${calibration.uvPerA[k]} uV/A`);
    }
  } finally {
    board.close();
  }
});

test('without these figures the same electronics are read wrongly', { skip: own !== undefined }, () => {
  const { rest, driven } = readings(process.env.HEDGEHOG_FIRMWARE_ELF);
  for (let k = 0; k < 3; ++k) {
    const zeroMa = (calibration.zeroUv[k] - kDesign.zeroUv) / kDesign.uvPerA * 1000;
    const gain = calibration.uvPerA[k] / kDesign.uvPerA;
    assert.ok(Math.abs(rest.measured[k] - rest.flows[k] - zeroMa) < kMaxErrorMa, `winding ${k}: ${rest.measured[k]} mA`);
    assert.ok(Math.abs(driven.measured[k] - gain * driven.flows[k] - zeroMa) < kMaxErrorMa, `winding ${k}: ${driven.measured[k]} mA`);
  }
});

/** The compiler's output for a calibration: '' when it is accepted. */
function compiled(text) {
  const header = join(folder, 'firmware/calibration.h');
  execFileSync('mkdir', ['-p', join(folder, 'firmware')]);
  writeFileSync(header, text);
  const { status, stderr } = spawnSync('arm-none-eabi-g++', ['-std=c++20', '-ffreestanding', '-fsyntax-only', `-I${folder}`, `-I${top}`, '-x', 'c++',
    join(top, 'firmware/pico_wiring.h')], { encoding: 'utf8' });
  return status === 0 ? '' : stderr;
}

test('a calibration may be as far from the design as its parts, and no farther', () => {
  const text = readFileSync(file, 'utf8');
  assert.equal(compiled(text), '');
  const put = (name, value) => text.replace(new RegExp(`(${name}(?:\\[\\])? = \\{?)[\\d']+`), `$1${value}`);
  for (const [name, min, max, sentence] of [
    ['kCurrentZeroUv', kDesign.zeroUv - 8000, kDesign.zeroUv + 8000, /a zero is .*repeat step 6/],
    ['kCurrentUvPerA', 0.97 * kDesign.uvPerA, 1.03 * kDesign.uvPerA, /a scale is .*repeat step 6/],
    ['kShuntUvPerA', 0.97 * kDesign.shuntUvPerA, 1.03 * kDesign.shuntUvPerA, /a scale is .*repeat step 6/],
  ]) {
    for (const value of [min, max]) assert.equal(compiled(put(name, value)), '', `${name} ${value}`);
    for (const value of [min - 1, max + 1, 0]) assert.match(compiled(put(name, value)), sentence, `${name} ${value}`);
  }
  assert.match(compiled(text.replace(/(kCurrentZeroUv\[\] = \{[^,]*,[^,]*),[^}]*/, '$1')), /three figures/);
});
