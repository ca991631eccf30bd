// SPDX-License-Identifier: MIT
// In Node.js: balls that announce themselves on the network, found when a program asks for them: `discover`, and addresses that begin
// with mdns://. One question by multicast to each IPv4 network of this machine; no other program is needed for it.
import crypto from "node:crypto";
import dgram from "node:dgram";
import os from "node:os";
import { describe } from "./addresses.js";
import { NotConnected } from "./errors.js";
import { Answers } from "./mdns.js";

const GROUP = "224.0.0.251";
const PORT = 5353;
/** Of the search for an address that begins with mdns://. */
const SEARCH_MS = 1000;
/** A lost one is replaced by the next, which also asks for what is missing. */
const QUERIES = 3;
/** Balls that an error names. */
const MAX_LISTED = 8;

/**
 * The balls that answer within that time, by name; one that has several addresses is there with each. Takes the whole time. Rejects
 * when this machine has no network.
 */
export function discover(timeoutMs = 1000) {
  return search(timeoutMs, null);
}

/** The same addresses with what one that begins with mdns:// has found. Rejects with NotConnected, and when there is no network. */
export async function locate(addresses) {
  const located = [];
  for (const address of addresses) {
    const { mdns, fingerprint } = address;
    if (mdns === undefined) {
      located.push(address);
      continue;
    }
    const balls = await search(SEARCH_MS, (found) => mdns !== "" && named(mdns, found).length > 0);
    for (const { address: host, port } of chosen(mdns, balls)) located.push({ host, port, tls: true, fingerprint });
  }
  return located;
}

/** Without TLS nothing is connected to. */
function secure(balls) {
  return balls.filter(({ tls }) => tls);
}

/** Those of that name, else those of that serial number. */
function named(text, balls) {
  const byName = secure(balls).filter(({ name }) => name === text);
  return byName.length > 0 ? byName : secure(balls).filter(({ serial }) => serial === text);
}

/** The addresses of the one ball that is meant; `text` empty: there is only one. Throws NotConnected. */
export function chosen(text, balls) {
  const all = secure(balls);
  const meant = text ? named(text, balls) : all;
  if (all.length === 0) throw new NotConnected("no ball answers on this network (mDNS, 1 s)");
  if (meant.length === 0)
    throw new NotConnected(`no ball "${text}" answers on this network (mDNS, 1 s); there are: ${listed(all)}`);
  if (meant.some(({ name }) => name !== meant[0].name)) {
    throw new NotConnected(
      `several balls answer on this network: ${listed(meant)}; choose one by its name or serial number, for example ` +
        describe({ mdns: meant[0].name }),
    );
  }
  return meant;
}

function listed(balls) {
  const first = new Map();
  for (const ball of balls) if (!first.has(ball.name)) first.set(ball.name, ball);
  const texts = [...first.values()].map(({ name, serial, address, port }) => {
    const number = serial === null ? "" : `serial ${serial}, `;
    return `"${name}" (${number}${describe({ host: address, port, tls: true })})`;
  });
  const more = texts.length > MAX_LISTED ? [`and ${texts.length - MAX_LISTED} more`] : [];
  return [...texts.slice(0, MAX_LISTED), ...more].join(", ");
}

/** HEDGEHOG_MDNS_PORT: for tests; that port is asked instead, on this machine only. */
function testPort() {
  return Number(/^\d+$/.exec(process.env.HEDGEHOG_MDNS_PORT ?? "")?.[0] ?? 0);
}

/** Ends after that time, or when what was found is `enough` (null: it never is). */
async function search(timeoutMs, enough) {
  const answers = new Answers(crypto.randomInt(1 << 16));
  const socket = dgram.createSocket("udp4");
  let found;
  const answered = new Promise((resolve) => (found = resolve));
  socket.on("message", (packet) => {
    if (answers.read(packet) && enough?.(answers.balls())) found(true);
  });
  try {
    await new Promise((resolve, reject) => socket.once("error", reject).bind(0, resolve));
    socket.on("error", () => {});
    socket.setMulticastTTL(255);
    const begin = performance.now();
    for (let query = 1; query <= QUERIES; ++query) {
      await ask(socket, answers.query());
      const leftMs = begin + (timeoutMs * query) / QUERIES - performance.now();
      let timer;
      const waited = new Promise((resolve) => (timer = setTimeout(resolve, Math.max(0, leftMs), false)));
      const ended = await Promise.race([answered, waited]);
      clearTimeout(timer);
      if (ended) break;
    }
    return answers.balls();
  } finally {
    socket.close();
  }
}

/** One after the other: the interface is the socket's. */
async function ask(socket, query) {
  const port = testPort();
  for (const address of port ? ["127.0.0.1"] : ipv4Addresses()) {
    try {
      socket.setMulticastInterface(address);
      await new Promise((resolve) => socket.send(query, port || PORT, GROUP, resolve));
    } catch {
      // The interface has gone meanwhile.
    }
  }
}

function ipv4Addresses() {
  const all = Object.values(os.networkInterfaces()).flat();
  return all.filter(({ family }) => family === "IPv4" || family === 4).map(({ address }) => address);
}
