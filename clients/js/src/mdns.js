// SPDX-License-Identifier: MIT
// Multicast DNS as far as one search needs it (RFC 6762, RFC 6763), without I/O. What is read came from the network: a message
// that is malformed anywhere counts for nothing, and texts have no control characters.

/**
 * Names are in the uncompressed form of RFC 1035, a byte of length before each label and 0 at the end, as strings of a character
 * per byte.
 */
export const SERVICE = "\x09_hedgehog\x04_tcp\x05local\0";

const A = 1;
const PTR = 12;
const TXT = 16;
const AAAA = 28;
const SRV = 33;
const IN = 1;
/** Of the class of a question: the response may be unicast. Of a record: it replaces others. */
const TOP_BIT = 0x8000;
const MAX_NAME = 255;
/** That one name leads through: each record may walk the whole chain again. */
const MAX_POINTERS = 32;
/** RFC 6762, section 17; IP's and UDP's headers included. */
const MAX_MESSAGE = 9000;
/** Of instances, and of names with services, texts or addresses each; further ones are ignored. */
const MAX_NAMES = 256;
const MAX_ADDRESSES = 16;
/** Of a query, in bytes; what does not fit is asked for later. */
const MAX_QUERY = 1200;

class Malformed extends Error {}

/** Reads one message from its first byte to its last. */
class Message {
  #data;
  at = 0;

  constructor(data) {
    this.#data = data;
  }

  take(size) {
    if (this.at + size > this.#data.length) throw new Malformed();
    this.at += size;
    return this.#data.subarray(this.at - size, this.at);
  }

  number(bytes) {
    return this.take(bytes).readUIntBE(0, bytes);
  }

  name() {
    let name = "";
    let end;
    let begin = this.at;
    let pointers = 0;
    for (;;) {
      const size = this.number(1);
      if (size >= 0xc0) {
        const target = ((size & 0x3f) << 8) | this.number(1);
        // Always further back: no name goes round in circles.
        if (target >= begin || ++pointers > MAX_POINTERS) throw new Malformed();
        end ??= this.at;
        this.at = begin = target;
        continue;
      }
      if (size > 63 || name.length + 1 + size > MAX_NAME) throw new Malformed();
      name += String.fromCharCode(size) + this.take(size).toString("latin1");
      if (size === 0) {
        this.at = end ?? this.at;
        return name;
      }
    }
  }
}

/** Without regard to case, of ASCII only, as DNS compares. */
function keyOf(name) {
  return name.replace(/[A-Z]/g, (letter) => letter.toLowerCase());
}

/** Any machine of the network wrote it: nothing that moves a terminal's cursor. */
export function printable(text) {
  return Buffer.from(text, "latin1").toString("utf8").replace(/[\x00-\x1f\x7f-\x9f]/g, "?");
}

function labels(name) {
  const all = [];
  for (let at = 0; name.charCodeAt(at) > 0; at += 1 + name.charCodeAt(at)) all.push(name.slice(at + 1, at + 1 + name.charCodeAt(at)));
  return all;
}

/** What has been answered to one search so far. */
export class Answers {
  #id;
  #instances = new Map();
  #services = new Map();
  #texts = new Map();
  #addresses = new Map();

  /** `id`, 0 to 65535, of its queries and of the responses that count. */
  constructor(id) {
    this.#id = id;
  }

  /** Asks for the service, and for what is missing of those that have answered. */
  query() {
    const questions = [[SERVICE, PTR]];
    for (const [key, instance] of this.#instances) {
      const service = this.#services.get(key);
      if (!service) questions.push([instance, SRV]);
      else if (!this.#addresses.has(keyOf(service.host))) questions.push([service.host, A]);
      if (!this.#texts.has(key)) questions.push([instance, TXT]);
    }
    const parts = [];
    let size = 12;
    for (const [name, kind] of questions) {
      const question = Buffer.from(`${name}\0\0\0\0`, "latin1");
      question.writeUInt16BE(kind, name.length);
      question.writeUInt16BE(IN | TOP_BIT, name.length + 2);
      if (size + question.length > MAX_QUERY) continue;
      size += question.length;
      parts.push(question);
    }
    const header = Buffer.alloc(12);
    header.writeUInt16BE(this.#id, 0);
    header.writeUInt16BE(parts.length, 4);
    return Buffer.concat([header, ...parts]);
  }

  /** Whether something in that datagram was of interest. */
  read(packet) {
    if (packet.length > MAX_MESSAGE) return false;
    let records;
    try {
      records = this.#records(new Message(packet));
    } catch (error) {
      if (error instanceof Malformed) return false;
      throw error;
    }
    for (const [name, kind, value] of records) this.#keep(keyOf(name), kind, value);
    return records.length > 0;
  }

  /** Those of which a host, a port and an address are known, by name. */
  balls() {
    const found = [];
    for (const [key, instance] of this.#instances) {
      const { host, port } = this.#services.get(key) ?? { port: 0 };
      if (port === 0) continue;
      const texts = this.#texts.get(key) ?? new Map();
      const text = (name) => (texts.has(name) ? printable(texts.get(name)) : null);
      for (const address of this.#addresses.get(keyOf(host)) ?? []) {
        found.push({
          name: printable(labels(instance)[0]),
          host: labels(host).map(printable).join("."),
          address,
          port,
          serial: text("serial"),
          protocol: text("protocol"),
          tls: texts.get("tls") === "1",
        });
      }
    }
    const order = ({ name, address }) => [name, address.includes(":") ? 1 : 0, address];
    return found.sort((a, b) => {
      const [one, other] = [order(a), order(b)];
      const differs = one.findIndex((value, i) => value !== other[i]);
      return differs < 0 ? 0 : one[differs] < other[differs] ? -1 : 1;
    });
  }

  #records(message) {
    const [id, flags, questions, ...counts] = Array.from({ length: 6 }, () => message.number(2));
    // A response to a standard query, without an error.
    if (id !== this.#id || (flags & 0xf80f) !== 0x8000) return [];
    for (let i = 0; i < questions; ++i) {
      message.name();
      message.take(4);
    }
    const records = [];
    for (let i = counts.reduce((sum, count) => sum + count); i > 0; --i) {
      const name = message.name();
      const kind = message.number(2);
      const kindClass = message.number(2);
      const lifetimeS = message.number(4);
      const size = message.number(2);
      const value = valueOf(message, kind, message.at + size);
      if ((kindClass & ~TOP_BIT) === IN && lifetimeS > 0 && value !== null) records.push([name, kind, value]);
    }
    return records;
  }

  #keep(key, kind, value) {
    const keepFirst = (known, name, first) => {
      if (known.size < MAX_NAMES && !known.has(name)) known.set(name, first);
    };
    if (kind === PTR) {
      // One label before the service's name.
      const length = value.charCodeAt(0);
      if (key === SERVICE && length > 0 && keyOf(value.slice(1 + length)) === SERVICE) keepFirst(this.#instances, keyOf(value), value);
    } else if (kind === SRV) {
      keepFirst(this.#services, key, value);
    } else if (kind === TXT) {
      keepFirst(this.#texts, key, value);
    } else {
      keepFirst(this.#addresses, key, []);
      const known = this.#addresses.get(key);
      if (known && !known.includes(value) && known.length < MAX_ADDRESSES) known.push(value);
    }
  }
}

/**
 * PTR: a name; SRV: host and port; TXT: its entries; A, AAAA: the address, but for those of a link, which lack their interface.
 * null: not of interest.
 */
function valueOf(message, kind, end) {
  let value = null;
  if (kind === PTR) {
    value = message.name();
  } else if (kind === SRV) {
    message.take(4);
    const port = message.number(2);
    value = { host: message.name(), port };
  } else if (kind === TXT) {
    value = new Map();
    while (message.at < end) {
      const entry = message.take(message.number(1)).toString("latin1");
      const equals = entry.indexOf("=");
      const key = keyOf(entry.slice(0, equals));
      if (equals >= 0 && !value.has(key)) value.set(key, entry.slice(equals + 1));
    }
  } else if (kind === A) {
    value = message.take(4).join(".");
  } else if (kind === AAAA) {
    const bytes = message.take(16);
    const linkLocal = (bytes.readUInt16BE(0) & 0xffc0) === 0xfe80;
    value = linkLocal ? null : ipv6Text(bytes);
  } else {
    message.take(Math.max(0, end - message.at));
  }
  if (message.at !== end) throw new Malformed();
  return value;
}

function ipv6Text(bytes) {
  const groups = Array.from({ length: 8 }, (_, i) => bytes.readUInt16BE(2 * i).toString(16));
  // Compressed as RFC 5952 has it.
  return new URL(`http://[${groups.join(":")}]`).hostname.slice(1, -1);
}
