// SPDX-License-Identifier: MIT
// How long, and how often, the tests look whether something has happened.
import assert from "node:assert/strict";
import { setTimeout } from "node:timers/promises";

/** Without a graphics card a busy machine takes seconds to draw a page. A condition that is checked at each frame, which is
 * playwright's default, has the browser draw sixty of them a second. */
export const kTimeout = { timeout: 120_000, polling: 50 };

/** Waits until `condition`, which runs outside the page, returns a value. */
export async function eventually(condition) {
  const end = Date.now() + kTimeout.timeout;
  while (!await condition()) {
    assert.ok(Date.now() < end, `never: ${condition}`);
    await setTimeout(50);
  }
}
