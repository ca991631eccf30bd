// SPDX-License-Identifier: MIT
// Where the daemon listens, found as by every client of Hedgehog: HEDGEHOG_ADDRESS, and nowhere else if it is set; otherwise the
// sockets in RUNTIME_DIRECTORY, /run/hedgehog and XDG_RUNTIME_DIR/hedgehog (/tmp/hedgehog-UID without these variables), then
// 127.0.0.1:7586. Only "mdns://" searches the network.
import { AddressError } from "./errors.js";

const PORT = 7586;
const SOCKET = "hedgehogd.sock";

function bad(text, why) {
  return new AddressError(
    `'${text}' is no address of a daemon: ${why} (for example 127.0.0.1:7586, [::1]:7586 or ` +
      "/run/hedgehog/hedgehogd.sock)",
  );
}

/** "host", "host:port", "[v6]:port", a bare IPv6 address, or "/path" → {host, port} or {path}; with "tls://" also {tls}. "mdns://NAME" → {mdns}. */
export function parseAddress(text) {
  if (text.startsWith("mdns://")) return { mdns: text.slice("mdns://".length) };
  if (text.startsWith("unix:") || text.startsWith("/")) {
    const path = text.replace(/^unix:/, "");
    if (!path) throw bad(text, "it names no socket");
    return { path };
  }
  const tls = text.startsWith("tls://");
  const place = tls ? text.slice("tls://".length) : text.replace(/^tcp:/, "");
  let host = place;
  let rest = "";
  if (place.startsWith("[")) {
    const close = place.indexOf("]");
    if (close < 0) throw bad(text, "']' is missing");
    host = place.slice(1, close);
    rest = place.slice(close + 1);
  } else if (place.split(":").length === 2) {
    [host, rest] = [place.slice(0, place.indexOf(":")), place.slice(place.indexOf(":"))];
  }
  if (!host) throw bad(text, "it names no host");
  if (!rest) return { host, port: PORT, ...(tls && { tls }) };
  const port = /^:\d+$/.test(rest) ? Number(rest.slice(1)) : 0;
  if (port < 1 || port > 65535) throw bad(text, "the port is a number from 1 to 65535");
  return { host, port, ...(tls && { tls }) };
}

/** As `hedgehogctl token certificate` prints it, or with a colon after each pair, as Node.js has it: "AB:CD:…". */
export function parseFingerprint(text) {
  const digits = text.replaceAll(":", "").toUpperCase();
  if (!/^[0-9A-F]{64}$/.test(digits)) {
    throw new AddressError(
      "the fingerprint is invalid: it must have 64 hexadecimal digits, as hedgehogctl token certificate prints it",
    );
  }
  return digits.match(/../g).join(":");
}

/** In the order in which they are tried. */
export function daemonAddresses(address, environment, uid, fingerprint) {
  const text = address || environment.HEDGEHOG_ADDRESS;
  if (text) {
    const parsed = parseAddress(text);
    const pinned = fingerprint || environment.HEDGEHOG_FINGERPRINT;
    const { tls, mdns } = parsed;
    if (mdns !== undefined && !pinned) {
      throw new AddressError(
        "mdns:// needs a fingerprint (HEDGEHOG_FINGERPRINT), as hedgehogctl token certificate prints it: any machine can " +
          "announce a ball",
      );
    }
    return [(tls || mdns !== undefined) && pinned ? { ...parsed, fingerprint: parseFingerprint(pinned) } : parsed];
  }
  const runtime = environment.RUNTIME_DIRECTORY;
  const session = environment.XDG_RUNTIME_DIR;
  // systemd may name several, separated by colons: the first is the daemon's.
  const folders = runtime ? [runtime.split(":")[0]] : [];
  folders.push("/run/hedgehog");
  if (session) folders.push(`${session}/hedgehog`);
  else if (!runtime && uid !== undefined) folders.push(`/tmp/hedgehog-${uid}`);
  return [...new Set(folders)].map((folder) => ({ path: `${folder}/${SOCKET}` })).concat({ host: "127.0.0.1", port: PORT });
}

export function describe({ path, host, port, tls, mdns }) {
  if (mdns !== undefined) return `mdns://${mdns}`;
  return path ?? (tls ? "tls://" : "") + (host.includes(":") ? `[${host}]:${port}` : `${host}:${port}`);
}
