// SPDX-License-Identifier: MIT
// What a program reads of the daemon's notifications, as an asynchronous iterator.
const DONE = { value: undefined, done: true };
/** Notifications that nobody has fetched; the oldest are dropped. */
const MAX_WAITING = 10_000;

/** Ends with `return()`, which also ends each `next()` that waits, or fails once with the Error that `fail` gave it. */
export class NotificationIterator {
  #begin;
  #end;
  #pick;
  #begun;
  #items = [];
  #waiting = [];
  #failure = null;
  #ended = false;

  /**
   * `begin`: called by the first `next()`; resolves once there may be notifications. `end`: called once it has ended. `pick`: of a method and
   * its parameters what is read, undefined: it is not.
   */
  constructor({ begin, end, pick }) {
    this.#begin = begin;
    this.#end = end;
    this.#pick = pick;
  }

  [Symbol.asyncIterator]() {
    return this;
  }

  add(method, params) {
    // What comes on a later connection is behind the failure.
    if (this.#failure || this.#ended) return;
    const item = this.#pick(method, params);
    if (item === undefined) return;
    if (this.#items.length >= MAX_WAITING) this.#items.shift();
    this.#items.push(item);
    this.#wake();
  }

  /** Once what came before is read. */
  fail(error) {
    this.#failure ??= error;
    this.#wake();
  }

  async next() {
    if (this.#ended) return DONE;
    this.#begun ??= this.#begin();
    this.#begun.catch((error) => this.fail(error));
    while (this.#items.length === 0 && !this.#failure && !this.#ended) {
      await new Promise((resolve) => this.#waiting.push(resolve));
    }
    if (this.#ended) return DONE;
    if (this.#items.length > 0) return { value: this.#items.shift(), done: false };
    await this.return();
    throw this.#failure;
  }

  async return() {
    if (!this.#ended) this.#end();
    this.#ended = true;
    this.#wake();
    return DONE;
  }

  #wake() {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}
