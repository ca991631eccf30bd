// SPDX-License-Identifier: MIT
// Timeouts of the tests.
import assert from "node:assert/strict";
import { setTimeout } from "node:timers/promises";

/** Without a graphics card a busy machine takes seconds to draw a page. */
export const kPatience = { timeout: 120_000 };

/** Waits until `look`, which runs outside the page, returns a value. */
export async function comes(look) {
  const end = Date.now() + kPatience.timeout;
  while (!await look()) {
    assert.ok(Date.now() < end, `never: ${look}`);
    await setTimeout(50);
  }
}
