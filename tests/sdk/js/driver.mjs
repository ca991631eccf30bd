// SPDX-License-Identifier: MIT
// Runs a step of a case on a Ball, in Node.js or in a page. The outcome is plain data, so that a browser can return it:
// {value}, {failure, message, retryS} or {error: {code, name, message, field}}.

// A line of a client must be shorter than 64 KiB; all together are far more than what the kernel and the library keep.
const FLOOD_BYTES = 30_000;
const FLOOD_LINES = 2000;

export class Driver {
  #library;
  #ball = null;
  #notifications;
  #reconnections = 0;
  #ended = [];
  #asked;
  #askedWhenEnded;
  #iterators = {};

  /** The module of the library: {Ball, NotConnected, RequestError, SubscriptionEnded}. */
  constructor(library) {
    this.#library = library;
  }

  open(options) {
    return this.#outcome(async () => {
      const { Ball, SubscriptionEnded } = this.#library;
      this.#ball = await Ball.connect({
        ...options,
        onReconnect: () => ++this.#reconnections,
        onSubscriptionEnded: (error) => {
          this.#ended.push(error instanceof SubscriptionEnded ? error.message : String(error));
          if (this.#askedWhenEnded) this.#ask(this.#askedWhenEnded);
        },
      });
      this.#notifications = this.#ball.notifications();
    });
  }

  do(step) {
    return this.#outcome(() => this.#action(step));
  }

  close() {
    this.#ball?.close();
  }

  #action(step) {
    const ball = this.#ball;
    if (step.not_finite) return this.#refused(ball.call(step.call, { ...step.params, [step.not_finite]: NaN }));
    if (step.call) return ball.call(step.call, step.params);
    if (step.call_again) return this.#again(step.call_again);
    // Not awaited: the response is checked in a later step.
    if (step.ask) return this.#ask(step.ask, step.params);
    if (step.ask_when_ended) {
      this.#askedWhenEnded = step.ask_when_ended;
      return null;
    }
    if (step.answered) return this.#answer();
    if (step.flood) return this.#flood(step.flood);
    if (step.rumble_again) return this.#rumbleAgain(step);
    if (step.next_of) return this.#nextOf(step.next_of);
    if (step.notify) return ball.notify(step.notify, step.params);
    if (step.rumble) return ball.rumble(step.rumble, step.strength, step.direction, step.params);
    if ("reconnected" in step) return this.#reconnections;
    if (step.subscriptions_ended) return this.#ended;
    return this.#notifications.next().then(({ value }) => value);
  }

  #ask(method, params) {
    this.#asked = this.#ball.call(method, params);
    this.#asked.catch(() => {});
    return null;
  }

  /** True: the library itself refuses the parameters. */
  #refused(called) {
    return called.then(
      () => false,
      (error) => error instanceof TypeError,
    );
  }

  async #answer() {
    while (!this.#asked) await new Promise((resolve) => setTimeout(resolve, 1));
    return this.#asked;
  }

  #flood(method) {
    for (let line = 0; line < FLOOD_LINES; ++line) {
      if (!this.#ball.notify(method, { text: "x".repeat(FLOOD_BYTES) })) return true;
    }
    return false;
  }

  async #rumbleAgain({ rumble_again, strength }) {
    while (!this.#ball.rumble(rumble_again, strength)) await new Promise((resolve) => setTimeout(resolve, 10));
    return true;
  }

  async #nextOf(kind) {
    this.#iterators[kind] ??= kind === "events" ? this.#ball.events() : this.#ball.telemetry(5);
    return (await this.#iterators[kind].next()).value;
  }

  async #again(method) {
    for (;;) {
      try {
        return await this.#ball.call(method);
      } catch (error) {
        if (!(error instanceof this.#library.NotConnected)) throw error;
        await new Promise((resolve) => setTimeout(resolve, error.retryAfterMs));
      }
    }
  }

  async #outcome(action) {
    const { NotConnected, RequestError } = this.#library;
    try {
      return { value: await action() };
    } catch (error) {
      if (error instanceof NotConnected) {
        // The iterator has ended with the connection.
        this.#notifications = this.#ball?.notifications();
        return { failure: "not_connected", message: error.message, retryS: error.retryAfterMs / 1000 };
      }
      if (!(error instanceof RequestError)) throw error;
      const { code, reason, message, data } = error;
      return { error: { code, name: reason, message, ...("field" in data ? { field: data.field } : {}) } };
    }
  }
}
