// SPDX-License-Identifier: MIT
// The page's connection to the daemon: JSON-RPC on /ws, one message a frame. Comes back by itself.
import { errorMessage } from "./words.js";

const kFirstPauseMs = 250;
const kLongestPauseMs = 2000;
const kTimeoutMs = 3000;
const kSecondMs = 300;
/** In sessionStorage: each tab has a token of its own, until it is closed. */
const kTokenKey = "hedgehog-token";
const kUnauthorized = -32003;

/** An answer that is an error; `data` as the protocol gives it. */
export class Refused extends Error {
  constructor(error) {
    super(error.message);
    this.code = error.code;
    this.data = error.data ?? {};
  }
}

/**
 * Dispatches `open` (detail: {hello, device}: the answers to hello and device.describe), `gone` (detail:
 * {reason, retryInMs}), `locked` (detail: {wrong, retryAfterMs}: the daemon needs a token; `wrong`: it has refused the one
 * that was sent; the next attempt is that of `unlock`, or comes after retryAfterMs where that is above 0), `telemetry` and `event` (detail: the notification's params).
 */
export class Link extends EventTarget {
  /** `begin`: requests to make after each hello, [{method, params}]. */
  constructor(client, begin = []) {
    super();
    this.client = client;
    this.begin = begin;
    this.url = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`;
    this.pauseMs = kFirstPauseMs;
    this.waiting = new Map();
    this.nextId = 0;
    this.closeReason = null;
    this.socket = null;
    this.ready = false;
    this.token = sessionStorage.getItem(kTokenKey);
    this.locked = false;
    this.connect();
  }

  hello() {
    return { client: this.client, protocol: "1.0", ...(this.token && { token: this.token }) };
  }

  connect() {
    clearTimeout(this.retry);
    this.locked = false;
    const socket = new WebSocket(this.url);
    this.socket = socket;
    // A daemon that is stopped in the debugger accepts, and never answers.
    const timeoutId = setTimeout(() => socket.close(), kTimeoutMs);
    socket.onopen = async () => {
      try {
        const hello = await this.call("hello", this.hello());
        const device = await this.call("device.describe");
        for (const { method, params } of this.begin) await this.call(method, params);
        clearTimeout(timeoutId);
        this.pauseMs = kFirstPauseMs;
        this.closeReason = null;
        this.ready = true;
        this.receivedAt = performance.now();
        this.emit("open", { hello, device });
      } catch (error) {
        if (error.code === kUnauthorized) this.lock(error);
        else if (error instanceof Refused) this.closeReason = errorMessage(error).replace(/\.$/, "");
        socket.close();
      }
    };
    socket.onmessage = (message) => this.receive(JSON.parse(message.data));
    socket.onclose = () => {
      clearTimeout(timeoutId);
      if (this.socket === socket) this.lost();
    };
  }

  lost() {
    this.ready = false;
    for (const { reject } of this.waiting.values()) reject(new Error("no connection to the daemon"));
    this.waiting.clear();
    if (this.locked) return;
    this.emit("gone", { reason: this.closeReason, retryInMs: this.pauseMs });
    this.retry = setTimeout(() => this.connect(), this.pauseMs);
    this.pauseMs = Math.min(2 * this.pauseMs, kLongestPauseMs);
  }

  /** `refusal`: what the daemon answered to hello. */
  lock({ data }) {
    this.locked = true;
    const wrong = this.token !== null;
    const retryAfterMs = data.retry_after_ms ?? 0;
    this.emit("locked", { wrong, retryAfterMs });
    if (retryAfterMs > 0) {
      // The daemon did not look at it; wrong ones of the same address, perhaps of others, came before.
      this.retry = setTimeout(() => this.connect(), retryAfterMs);
      return;
    }
    this.token = null;
    sessionStorage.removeItem(kTokenKey);
  }

  unlock(token) {
    this.token = token;
    sessionStorage.setItem(kTokenKey, token);
    this.connect();
  }

  receive(message) {
    this.receivedAt = performance.now();
    if (message.method === "event" && message.params.type === "shutting_down") {
      this.closeReason = message.params.reason;
    }
    if (message.method) {
      this.emit(message.method, message.params);
      return;
    }
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) waiting?.reject(new Refused(message.error));
    else waiting?.resolve(message.result);
  }

  emit(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Since the daemon was last heard, ms. */
  silentMs() {
    return performance.now() - (this.receivedAt ?? 0);
  }

  call(method, params = {}) {
    if (this.socket?.readyState !== WebSocket.OPEN) return Promise.reject(new Error("no connection to the daemon"));
    const id = ++this.nextId;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.socket.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
    });
  }

  /** Unanswered: for what is said again and again. */
  notify(method, params = {}) {
    if (this.ready) this.socket.send(JSON.stringify({ jsonrpc: "2.0", method, params }));
  }

  /**
   * The emergency stop. A connection that hangs must not keep it: when no answer comes, a second one is
   * opened for this alone. Resolves when the daemon has confirmed, be it late; rejects when nobody can any more.
   */
  emergencyStop() {
    const here = this.call("device.emergency_stop");
    const elsewhere = new Promise((resolve, reject) => {
      const timer = setTimeout(() => {
        const socket = new WebSocket(this.url);
        const timeoutId = setTimeout(() => socket.close(), kTimeoutMs);
        socket.onopen = () => {
          socket.send(JSON.stringify({ jsonrpc: "2.0", id: 1, method: "hello", params: this.hello() }));
          socket.send('{"jsonrpc":"2.0","id":2,"method":"device.emergency_stop"}');
        };
        socket.onmessage = ({ data }) => {
          const { id, result } = JSON.parse(data);
          if (id !== 2) return;
          if (result) resolve(result);
          socket.close();
        };
        socket.onclose = () => {
          clearTimeout(timeoutId);
          reject(new Error("no connection to the daemon"));
        };
      }, kSecondMs);
      here.then(() => clearTimeout(timer), () => {});
    });
    return Promise.any([here, elsewhere]);
  }
}
