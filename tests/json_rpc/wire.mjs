// SPDX-License-Identifier: MIT
// Connections that send bytes as they are, whether JSON or not.
import { createRequire } from 'node:module';
import net from 'node:net';
import { createInterface } from 'node:readline';

const packages = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const WebSocket = packages('ws');

/** Received from the daemon, in order: messages, then `{ closed: code }` once the connection has ended. */
class Incoming {
  #items = [];
  #waiting = [];

  add(item) {
    const next = this.#waiting.shift();
    if (next) next(item);
    else this.#items.push(item);
  }

  next() {
    return this.#items.length > 0 ? Promise.resolve(this.#items.shift()) : new Promise((resolve) => this.#waiting.push(resolve));
  }
}

class Wire {
  incoming = new Incoming();
  #pings = 0;

  /** Sends `document` and a ping; returns the messages before the ping's response or the end of the connection. */
  async exchange(document) {
    const id = `ping ${++this.#pings}`;
    this.send(document);
    this.send(Buffer.from(JSON.stringify({ jsonrpc: '2.0', id, method: 'ping' })));
    const responses = [];
    for (;;) {
      const item = await this.incoming.next();
      if (item.closed !== undefined) return { responses, closed: item.closed };
      if (item.id === id) return { responses, closed: null, pong: item };
      responses.push(item);
    }
  }
}

export class TcpWire extends Wire {
  static open(daemon) {
    const wire = new TcpWire();
    wire.socket = net.connect(daemon.tcp, '127.0.0.1');
    // Bytes that the daemon no longer reads reset the connection.
    wire.socket.on('error', () => {});
    wire.socket.on('close', () => wire.incoming.add({ closed: 'connection' }));
    createInterface({ input: wire.socket }).on('line', (line) => wire.incoming.add(JSON.parse(line)));
    return new Promise((resolve) => wire.socket.on('connect', () => resolve(wire)));
  }

  send(bytes) {
    this.socket.write(bytes.at(-1) === 0x0a ? bytes : Buffer.concat([bytes, Buffer.from('\n')]));
  }

  end() { this.socket.destroy(); }
}

export class WebSocketWire extends Wire {
  static open(daemon) {
    const wire = new WebSocketWire();
    wire.socket = new WebSocket(`ws://127.0.0.1:${daemon.port}/ws`);
    wire.socket.on('close', (code) => wire.incoming.add({ closed: code }));
    wire.socket.on('message', (text) => wire.incoming.add(JSON.parse(text)));
    return new Promise((resolve, reject) => wire.socket.on('open', () => resolve(wire)).on('error', reject));
  }

  send(bytes) { this.socket.send(bytes, { binary: false }); }

  end() { this.socket.terminate(); }
}
