// SPDX-License-Identifier: MIT
// The closed loop: a change at the converter's input is reported in a telemetry frame, the host responds in its next frame, and the
// response reaches the PWM. The host is the simplest controller: two duties, selected by the current of winding x.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withBoard } from './fixture.mjs';
import { compareValue, kMode, setPoint, telemetry } from './frames.mjs';
import { histogram, percentile } from './histogram.mjs';

/** MCP3208: no current, and 0.4 A. */
const kCodes = [2048, 2073];
const kThresholdMa = 200;
const kDuties = [0.01, 0.02];
const kCompares = kDuties.map((duty) => compareValue(Math.round(duty * 32767)));
const kChanges = 200;
/** A conversion in each millisecond, that of winding x 0.2 ms into the host's frame, which is sent by the start of the next (E15); the
 *  host's next frame after the telemetry; from a set-point to its PWM. */
const kMaxUs = { telemetry: 1000 + 800, command: 1000, pwm: 1000 };
/** Widths of the bins of their histograms. */
const kBinsUs = { telemetry: 200, command: 5, pwm: 10 };

test('from a changed current to the PWM that answers it: at most the sum of its three parts', withBoard((board, driver) => {
  driver.drive([kDuties[0], 0, 0], 60);
  board.shownCurrent = kCodes[0];
  let level = 0; // as in the latest telemetry
  let change; // the one in progress
  const done = [];
  board.host.onFrame = () => {
    board.host.outQueue.push(setPoint(++driver.sequence, { duty: [kDuties[level], 0, 0] }));
    if (change?.telemetryUs && !change.commandUs) change.commandUs = board.chip.us;
  };
  board.host.onIn = (packet, us) => {
    driver.last = telemetry(packet);
    level = driver.last.currentMa[0] > kThresholdMa ? 1 : 0;
    if (change && level === change.level) change.telemetryUs ??= us;
  };
  for (let i = 1; i <= kChanges; ++i) {
    // At a different phase of the millisecond each time.
    board.run(10 + (i % 20) / 20);
    board.applied.length = 0;
    change = { level: i % 2, us: board.chip.us };
    board.shownCurrent = kCodes[change.level];
    board.run(10, () => board.applied.some(({ us, value }) => us > change.us && value === kCompares[change.level]));
    const applied = board.applied.find(({ us, value }) => us > change.us && value === kCompares[change.level]);
    assert.ok(applied && change.commandUs, `change ${i} is not answered: mode ${driver.last.mode}, faults ${driver.last.faults}`);
    done.push({ ...change, pwmUs: applied.us });
  }
  assert.equal(driver.last.mode, kMode.driving);
  const parts = {
    telemetry: done.map(({ us, telemetryUs }) => telemetryUs - us),
    command: done.map(({ telemetryUs, commandUs }) => commandUs - telemetryUs),
    pwm: done.map(({ commandUs, pwmUs }) => pwmUs - commandUs),
  };
  const all = done.map(({ us, pwmUs }) => pwmUs - us);
  console.log(`current to PWM, all around the loop: median ${percentile(all, 0.5).toFixed(0)} us, worst ${percentile(all, 1).toFixed(0)} us\n${histogram(all, 200)}`);
  for (const [part, values] of Object.entries(parts)) {
    console.log(`to the ${part}: median ${percentile(values, 0.5).toFixed(0)} us, worst ${percentile(values, 1).toFixed(0)} us\n${histogram(values, kBinsUs[part])}`);
    assert.ok(percentile(values, 1) <= kMaxUs[part], `${part}: ${percentile(values, 1)} us`);
  }
  // The response takes at least a conversion, a frame in each direction, and the end of a PWM period.
  assert.ok(Math.min(...all) > 500 && Math.max(...all) <= kMaxUs.telemetry + kMaxUs.command + kMaxUs.pwm);
}));
