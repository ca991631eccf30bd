// SPDX-License-Identifier: MIT
// How long a test waits for what it looks for.
import assert from "node:assert/strict";
import { setTimeout } from "node:timers/promises";

/** A busy machine draws a page without a graphics card in seconds. */
export const kPatience = { timeout: 120_000 };

/** Ends when `look` gives something, outside the page. */
export async function comes(look) {
  const end = Date.now() + kPatience.timeout;
  while (!await look()) {
    assert.ok(Date.now() < end, `never: ${look}`);
    await setTimeout(50);
  }
}
