// SPDX-License-Identifier: MIT
// How long attempts to connect take, and wait for the next one. Times in milliseconds of performance.now().
const FIRST_WAIT_MS = 100;
const MAX_WAIT_MS = 5000;

/** 0.1, 0.2, 0.4 ... 5 s. */
export class Backoff {
  #waitMs = 0;
  #nextAttempt = 0;

  remainingMs() {
    return Math.max(0, this.#nextAttempt - performance.now());
  }

  /** The wait until the next attempt. `atLeastMs`: the daemon accepts no connection earlier. */
  failed(atLeastMs) {
    this.#waitMs = Math.min(MAX_WAIT_MS, this.#waitMs ? 2 * this.#waitMs : FIRST_WAIT_MS);
    const wait = Math.max(this.#waitMs, atLeastMs);
    this.#nextAttempt = performance.now() + wait;
    return wait;
  }

  succeeded() {
    this.#waitMs = 0;
    this.#nextAttempt = 0;
  }
}

/**
 * The time until `deadline` for one of so many attempts that are left: one that gets no response leaves some to the next. At least
 * 1 ms, so that a daemon that answers at once is still found.
 */
export function shareOf(deadline, attempts = 1) {
  return Math.max(1, (deadline - performance.now()) / attempts);
}
