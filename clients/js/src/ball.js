// SPDX-License-Identifier: MIT
// The client over any transport that carries a message a line or a frame.
import { Backoff, shareOf } from "./backoff.js";
import { NotConnected, RequestError, SubscriptionEnded } from "./errors.js";
import { Methods } from "./methods.js";
import { NotificationIterator } from "./notifications.js";
import { given, requestText } from "./request.js";
import { Subscriptions } from "./subscriptions.js";

/** A rumble ends so long after its last frame: a game that hangs lets go of the ball. */
const LEASE_MS = 250;
/** The longest wait until the next connection that a daemon can ask for. */
const MAX_RETRY_AFTER_MS = 60_000;
/** What a daemon that does not read may leave unsent, in bytes. */
const MAX_UNSENT = 1 << 20;

/** `strength` 0..1 as a level: anything above 0 begins where a push can be felt. */
export function feltLevel(strength, limits) {
  if (!(strength > 0) || !(limits.current_a > 0)) return 0;
  const felt = Math.min(1, limits.felt_a / limits.current_a);
  return felt + (1 - felt) * Math.min(1, strength);
}

/**
 * A connection to the daemon; the effects of a connection end with it. After a lost connection the next call connects
 * anew, no more often than its back-off allows. What the program subscribed to is subscribed to again; its effects are
 * not made again: `onReconnect(hello)` is called after each connection but the first. A subscription that the new daemon
 * refuses has ended: `onSubscriptionEnded(error)` is called.
 *
 * `connectors`: resolves to functions that open a transport, tried in order, or rejects with an Error that says why there are none; is
 * called for each attempt. Each function is given `{message, ended, timeoutMs}` and resolves to
 * `{send(text), unsent(), close()}` or rejects with an Error that says where and why; `unsent`: bytes that wait for the daemon.
 */
export class BallCore extends Methods {
  #connectors;
  #hello;
  #timeoutMs;
  #transport = null;
  #connecting = null;
  #lastId = 0;
  #pending = new Map();
  #subscribers = new Set();
  #backoff = new Backoff();
  /** The error that the daemon sent last, if it answers no request: why it closes the connection. */
  #notice = null;
  #closed = false;
  #connections = 0;
  #onReconnect;
  #onSubscriptionEnded;
  #subscriptions = new Subscriptions();
  /** What the daemon said of itself: server, role, limits. */
  hello = null;

  constructor(connectors, { name = "javascript", timeoutMs = 2000, token, onReconnect, onSubscriptionEnded } = {}) {
    super();
    this.#connectors = connectors;
    this.#hello = given({ client: name, protocol: "1", token });
    this.#timeoutMs = timeoutMs;
    this.#onReconnect = onReconnect;
    this.#onSubscriptionEnded = onSubscriptionEnded;
  }

  get connected() {
    return this.#transport !== null;
  }

  /** Ends the connection, and with it its effects. */
  close() {
    this.#closed = true;
    this.#end("this ball is closed");
  }

  /**
   * The result of a method. Rejects with RequestError when the daemon refuses, with NotConnected when there is none, with TypeError
   * for a parameter that JSON does not have (a BigInt, a cycle, NaN).
   */
  async call(method, params = {}) {
    await this.open();
    const change = this.#subscriptions.sent(method, params);
    const result = await this.#ask(method, params);
    this.#subscriptions.carriedOut(change);
    return result;
  }

  /** Sends without waiting for a response. False: nothing was sent, there is no daemon; then it connects meanwhile. */
  notify(method, params = {}) {
    if (!this.#transport || !this.hello) {
      this.open().catch(() => {});
      return false;
    }
    if (!this.#send(requestText({ method }, params))) return false;
    this.#subscriptions.carriedOut(this.#subscriptions.sent(method, params));
    return true;
  }

  /** A vibration that goes on while this is called every frame; strength 0..1, 0 ends it. As `notify`. */
  rumble(slot, strength, direction, params = {}) {
    if (!(strength > 0)) return this.notify("effect.stop", { slot });
    if (!this.hello) return this.notify("effect.vibrate");
    const level = feltLevel(strength, this.hello.limits);
    return this.notify("effect.vibrate", { slot, direction, lease_ms: LEASE_MS, ...params, level });
  }

  /** Events as they come: `for await (const event of ball.events(["effect_ended"]))`. */
  events(types, { scope } = {}) {
    return this.#subscribed("event", "events.subscribe", { types, scope });
  }

  /** The status again and again. */
  telemetry(rate_hz = 10, fields) {
    return this.#subscribed("telemetry", "telemetry.subscribe", { rate_hz, fields });
  }

  /** Every notification as `[method, params]`, from now on; throws NotConnected when the connection ends. */
  notifications() {
    const all = this.#iterator({ begin: async () => {}, pick: (method, params) => [method, params] });
    this.#subscribe(all);
    return all;
  }

  #subscribed(kind, subscribe, params) {
    const begin = () => {
      this.#subscribe(some);
      return this.call(subscribe, params);
    };
    const some = this.#iterator({ begin, pick: (method, received) => (method === kind ? received : undefined) });
    return some;
  }

  #iterator(functions) {
    const made = new NotificationIterator({ ...functions, end: () => this.#subscribers.delete(made) });
    return made;
  }

  #subscribe(iterator) {
    if (this.#closed) iterator.fail(new NotConnected("this ball is closed"));
    else this.#subscribers.add(iterator);
  }

  /** Connects, unless it is. */
  open() {
    if (this.#closed) return Promise.reject(new NotConnected("this ball is closed"));
    if (this.#transport && this.hello) return Promise.resolve();
    this.#connecting ??= this.#connect().finally(() => (this.#connecting = null));
    return this.#connecting;
  }

  async #connect() {
    const wait = this.#backoff.remainingMs();
    if (wait > 0) throw new NotConnected(`the daemon does not run; next attempt in ${(wait / 1000).toFixed(1)} s`, wait);
    const connectors = await this.#connectors().catch(({ message }) => {
      throw this.#failed(message);
    });
    const why = [];
    // One for all addresses and the introduction.
    const deadline = performance.now() + this.#timeoutMs;
    for (const connect of connectors) {
      try {
        this.#transport = await this.#openTransport(connect, shareOf(deadline, connectors.length - why.length));
        break;
      } catch (error) {
        why.push(error.message);
      }
    }
    if (!this.#transport) throw this.#failed(`the daemon does not run: ${why.join("; ")}`);
    if (this.#closed) throw this.#end("this ball is closed");
    try {
      this.hello = await this.#ask("hello", this.#hello, shareOf(deadline));
    } catch (error) {
      // Without the response to `hello` the connection is of no use.
      if (!(error instanceof NotConnected)) this.#end(error.message);
      throw error;
    }
    this.#backoff.succeeded();
    for (const change of this.#subscriptions.current()) this.#renew(change);
    const { hello } = this;
    if (this.#connections++ > 0) queueMicrotask(() => this.#onReconnect?.(hello));
  }

  /** Nobody waits for this response. */
  #renew(change) {
    const id = ++this.#lastId;
    const reject = (error) => {
      if (!(error instanceof RequestError) || !this.#subscriptions.refused(change)) return;
      const ended = new SubscriptionEnded(change.method, error);
      queueMicrotask(() => this.#onSubscriptionEnded?.(ended));
    };
    this.#pending.set(id, { resolve() {}, reject });
    this.#send(requestText({ id, method: change.method }, change.params));
  }

  async #openTransport(connect, timeoutMs) {
    let current = true;
    const transport = await connect({
      message: (text) => current && this.#receive(text),
      ended: (reason) => {
        if (!current) return;
        current = false;
        this.#endOf(reason);
      },
      timeoutMs,
    });
    return {
      send: (text) => transport.send(text),
      unsent: () => transport.unsent(),
      close: () => {
        current = false;
        transport.close();
      },
    };
  }

  #ask(method, params, timeoutMs = this.#timeoutMs) {
    return new Promise((resolve, reject) => {
      if (!this.#transport) {
        reject(new NotConnected("the connection to the daemon has ended"));
        return;
      }
      const id = ++this.#lastId;
      // Before anything waits for the response: this can throw.
      const text = requestText({ id, method }, params);
      const timer = setTimeout(() => this.#end(`${method}: no response within ${this.#timeoutMs / 1000} s`), timeoutMs);
      this.#pending.set(id, { resolve, reject, timer });
      this.#send(text);
    });
  }

  /** False: the connection has ended. */
  #send(text) {
    if (!this.#transport) return false;
    this.#transport.send(text);
    if (this.#transport.unsent() <= MAX_UNSENT) return true;
    this.#end("the daemon does not read from the connection");
    return false;
  }

  #receive(text) {
    let message;
    try {
      message = JSON.parse(text);
    } catch {
      message = null;
    }
    if (message === null || typeof message !== "object") {
      this.#end("the server is not a Hedgehog daemon");
      return;
    }
    this.#notice = (message.id ?? null) === null && message.error ? message.error : null;
    if (typeof message.method === "string") {
      for (const subscriber of this.#subscribers) subscriber.add(message.method, message.params ?? {});
      return;
    }
    const waiting = this.#pending.get(message.id);
    if (!waiting) return;
    this.#pending.delete(message.id);
    clearTimeout(waiting.timer);
    if (message.error) {
      waiting.reject(new RequestError(message.error.code, message.error.message, message.error.data));
    } else {
      waiting.resolve(message.result);
    }
  }

  /** The daemon has closed the connection. */
  #endOf(otherwise) {
    const { message, data } = this.#notice ?? {};
    const retryAfterMs = Number(data?.retry_after_ms) || 0;
    this.#end(typeof message === "string" ? message : otherwise, Math.min(MAX_RETRY_AFTER_MS, retryAfterMs));
  }

  /** Everybody who waits is told. */
  #end(why, retryAfterMs = 0) {
    const transport = this.#transport;
    this.#transport = null;
    this.hello = null;
    this.#notice = null;
    transport?.close();
    const lost = this.#failed(`the connection to the daemon has ended: ${why}`, retryAfterMs);
    for (const { reject, timer } of this.#pending.values()) {
      clearTimeout(timer);
      reject(lost);
    }
    this.#pending.clear();
    for (const subscriber of this.#subscribers) subscriber.fail(lost);
    return lost;
  }

  /** retryAfterMs: the daemon wants no connection earlier. */
  #failed(message, retryAfterMs = 0) {
    return new NotConnected(message, this.#backoff.failed(retryAfterMs));
  }
}
