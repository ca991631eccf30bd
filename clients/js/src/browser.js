// SPDX-License-Identifier: MIT
// In a browser: over WebSocket. Pages that the daemon does not serve itself need `http.allow_origins` in its configuration.
import { BallCore } from "./ball.js";
import { NotConnected } from "./errors.js";

export * from "./error_codes.js";
export * from "./errors.js";

function connector(address) {
  return ({ message, ended, timeoutMs }) =>
    new Promise((resolve, reject) => {
      const socket = new WebSocket(address);
      let open = false;
      const timer = setTimeout(() => socket.close(), timeoutMs);
      socket.onopen = () => {
        open = true;
        clearTimeout(timer);
        resolve({ send: (text) => socket.send(text), unsent: () => socket.bufferedAmount, close: () => socket.close() });
      };
      socket.onmessage = ({ data }) => message(data);
      socket.onclose = ({ code }) => {
        clearTimeout(timer);
        if (open) ended(code === 1001 ? "the daemon shuts down" : "the daemon closed it");
        else reject(new NotConnected(`${address}: no WebSocket there, or this page's origin is not allowed`));
      };
    });
}

export class Ball extends BallCore {
  /** `address`: the WebSocket's; without, that of the daemon on this machine. */
  constructor({ address = "ws://127.0.0.1:7587/ws", ...options } = {}) {
    super(async () => [connector(address)], options);
  }

  /** A ball that is connected. Rejects with NotConnected or RequestError. */
  static async connect(options) {
    const ball = new Ball(options);
    await ball.open();
    return ball;
  }
}
