// SPDX-License-Identifier: MIT
// What can go wrong, each with a sentence for people.

export class BallError extends Error {
  constructor(message) {
    super(message);
    this.name = new.target.name;
  }
}

/** HEDGEHOG_ADDRESS, or the address that was given, is none. */
export class AddressError extends BallError {}

/** No daemon answers, or the connection has ended. The next call tries again, no earlier than after `retryAfterMs`. */
export class NotConnected extends BallError {
  constructor(message, retryAfterMs = 0) {
    super(message);
    this.retryAfterMs = retryAfterMs;
  }
}

/** The daemon refused a request. `code`: of JSON-RPC or of the protocol; `reason`: "invalid_params"; `data`: field, limit, value. */
export class RequestError extends BallError {
  constructor(code, message, data = {}) {
    super(message);
    this.code = code;
    this.data = data ?? {};
    this.reason = String(this.data.name ?? "");
  }
}

/** The daemon refused to renew a subscription on a new connection; it has ended. `method`: "events.subscribe". */
export class SubscriptionEnded extends RequestError {
  constructor(method, { code, message, data }) {
    super(code, `${method}: ${message}`, data);
    this.method = method;
  }
}
