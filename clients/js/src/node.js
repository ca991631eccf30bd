// SPDX-License-Identifier: MIT
// In Node.js: over TCP, with TLS or without, or a Unix socket.
import net from "node:net";
import { StringDecoder } from "node:string_decoder";
import tls from "node:tls";
import { daemonAddresses, describe } from "./addresses.js";
import { BallCore } from "./ball.js";
import { locate } from "./discovery.js";
import { NotConnected } from "./errors.js";

export { discover } from "./discovery.js";
export * from "./error_codes.js";
export * from "./errors.js";

const CAUSES = { ECONNREFUSED: "Connection refused", ENOENT: "No such file or directory", EACCES: "Permission denied" };

/** Longer than any response. */
const MAX_LINE = 4 << 20;

/** With a fingerprint no authority has to vouch for the certificate: that is compared before anything is sent. */
function connect(address) {
  if (!address.tls) return net.connect(address);
  const { host, port, fingerprint } = address;
  const servername = net.isIP(host) ? "" : host;
  return tls.connect({ host, port, servername, minVersion: "TLSv1.3", rejectUnauthorized: !fingerprint });
}

/** Why this is not the daemon that `address` means; undefined: it is. */
function mistaken(socket, { fingerprint }) {
  const seen = fingerprint && socket.getPeerCertificate().fingerprint256;
  return seen === fingerprint ? undefined : new Error(`its certificate has another fingerprint: ${seen}`);
}

function connector(address) {
  return ({ message, ended, timeoutMs }) =>
    new Promise((resolve, reject) => {
      const socket = connect(address);
      const decoder = new StringDecoder("utf8");
      let partial = "";
      let open = false;
      let cause = "the daemon closed it";
      const timer = setTimeout(() => socket.destroy(new Error("no answer")), timeoutMs);
      socket.setNoDelay(true);
      socket.on(address.tls ? "secureConnect" : "connect", () => {
        const mistake = mistaken(socket, address);
        if (mistake) return socket.destroy(mistake);
        open = true;
        clearTimeout(timer);
        resolve({
          send: (text) => socket.write(text + "\n"),
          unsent: () => socket.writableLength,
          close: () => socket.destroy(),
        });
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
  /**
   * `address`: "127.0.0.1:7586", "tls://host:7586", "mdns://ball-7" or "/run/hedgehog/hedgehogd.sock"; without, found as by every client.
   * `token` and `fingerprint`: else HEDGEHOG_TOKEN and HEDGEHOG_FINGERPRINT. Throws AddressError.
   */
  constructor({ address, fingerprint, token = process.env.HEDGEHOG_TOKEN || undefined, ...options } = {}) {
    const addresses = daemonAddresses(address, process.env, process.getuid?.(), fingerprint);
    super(async () => (await locate(addresses)).map(connector), { token, ...options });
  }

  /** A ball that is connected. Rejects with NotConnected or RequestError. */
  static async connect(options) {
    const ball = new Ball(options);
    await ball.open();
    return ball;
  }
}
