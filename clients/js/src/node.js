// SPDX-License-Identifier: MIT
// In Node.js: over TCP or a Unix socket.
import net from "node:net";
import { StringDecoder } from "node:string_decoder";
import { daemonAddresses, describe } from "./addresses.js";
import { BallCore } from "./ball.js";
import { NotConnected } from "./errors.js";

export * from "./error_codes.js";
export * from "./errors.js";

const CAUSES = { ECONNREFUSED: "Connection refused", ENOENT: "No such file or directory", EACCES: "Permission denied" };

/** Longer than any response. */
const MAX_LINE = 4 << 20;

function connector(address) {
  return ({ message, ended, patienceMs }) =>
    new Promise((resolve, reject) => {
      const socket = net.connect(address);
      const decoder = new StringDecoder("utf8");
      let partial = "";
      let open = false;
      let cause = "the daemon closed it";
      const timer = setTimeout(() => socket.destroy(new Error("no answer")), patienceMs);
      socket.setNoDelay(true);
      socket.on("connect", () => {
        open = true;
        clearTimeout(timer);
        resolve({ send: (text) => socket.write(text + "\n"), close: () => socket.destroy() });
      });
      socket.on("data", (bytes) => {
        const lines = (partial + decoder.write(bytes)).split("\n");
        partial = lines.pop();
        if (partial.length > MAX_LINE) socket.destroy(new Error("a line of more than 4 MiB"));
        for (const line of lines) if (line.trim()) message(line);
      });
      socket.on("error", (error) => (cause = CAUSES[error.code] ?? error.message));
      socket.on("close", () => {
        clearTimeout(timer);
        if (open) ended(cause);
        else reject(new NotConnected(`${describe(address)}: ${cause}`));
      });
    });
}

export class Ball extends BallCore {
  /** `address`: "127.0.0.1:7586" or "/run/hedgehog/hedgehogd.sock"; without, found as by every client. Throws AddressError. */
  constructor({ address, ...options } = {}) {
    super(daemonAddresses(address, process.env, process.getuid?.()).map(connector), options);
  }

  /** A ball that is connected. Rejects with NotConnected or RequestError. */
  static async connect(options) {
    const ball = new Ball(options);
    await ball.open();
    return ball;
  }
}
