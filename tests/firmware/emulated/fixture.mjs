// SPDX-License-Identifier: MIT
// A board and its host for one test.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Board, Driver } from './board.mjs';
import { kMode } from './frames.mjs';

let saved = 0;

function saveCoverage(board) {
  const folder = process.env.HEDGEHOG_FIRMWARE_COVERAGE;
  if (folder) writeFileSync(join(folder, `${process.pid}-${++saved}.json`), JSON.stringify(board.chip.executed()));
}

export function withBoard(body, options) {
  return () => {
    const board = new Board(undefined, options);
    try {
      const driver = new Driver(board);
      body(board, driver);
      assert.equal(board.host.counts.toggle, 0, 'data toggles');
      assert.equal(board.host.counts.unarmed, 0, 'buffers armed in one step');
      assert.equal(board.host.counts.late, 0, 'bulk packets armed at the end of a frame (E15)');
    } finally {
      saveCoverage(board);
      board.close();
    }
  };
}

/** No current flows in any winding, and none starts within 5 ms. */
export function assertNoCurrent(board) {
  for (let ms = 0; ms < 5; ++ms) {
    assert.ok(board.trueMa < 1, `${board.trueMa} mA flow`);
    board.run(1);
  }
}

export function assertSafePins(board) {
  const pins = board.pins();
  assert.equal(pins.awake, false, 'SLP');
  assert.deepEqual(pins.pwm, [0, 0, 0]);
  assert.equal(pins.fan, 4999, 'fan');
}

/** The board drives more than 4 A, the precondition of the tests that stop it. */
export function assertDriving(board, driver) {
  assert.equal(driver.last.mode, kMode.driving);
  assert.ok(board.trueMa > 4000, `${board.trueMa} mA`);
}

export const kFiveAmps = [0.19, 0, 0];
