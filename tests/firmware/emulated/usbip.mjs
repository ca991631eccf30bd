// SPDX-License-Identifier: MIT
// The emulated board for hedgehog-usbip (device `firmware-board`) in an emulated machine: usbip.mjs SOCKET listens on that Unix socket, which
// qemu connects to a serial port, and serves one connection. Messages: emulator/firmware/README.md. run.sh has the environment.
// Exit: 0 the connection has ended, 64 usage, 70 the board or a message is in error, which is also sent.
import { createServer } from 'node:net';
import { Board } from './board.mjs';
import { BoardTrace } from './board_trace.mjs';
import { crc32 } from './frames.mjs';

const kStart = 0x48;
const kHead = 4;
const kCrc = 4;
const kMaxPayload = 4096;
const kResponse = 0x80;
const kError = 0xff;

function encode(type, payload) {
  const message = Buffer.alloc(kHead + payload.length + kCrc);
  message.set([kStart, type]);
  message.writeUInt16LE(payload.length, 2);
  payload.copy(message, kHead);
  message.writeUInt32LE(crc32(message.subarray(0, -kCrc)), kHead + payload.length);
  return message;
}

class RemoteBoard {
  constructor() {
    this.board = new Board();
    this.host = this.board.host;
    this.events = '';
    this.trace = new BoardTrace(this.board, (line) => { this.events += line; });
    this.peakA = 0;
    this.frames = { in: 0, out: 0 };
    const { onOut } = this.host;
    this.host.onOut = (packet, us) => {
      ++this.frames.in;
      onOut(packet, us);
    };
    this.host.onStall = (address) => this.halted.add(address);
    this.host.onIn = () => {
      ++this.frames.out;
      this.host.reading = --this.reads > 0;
    };
    this.halted = new Set();
    this.dueUs = 0;
    this.unplug();
  }

  plug() {
    this.halted.clear();
    this.host.plug(true);
    this.board.chip.setPowered(true);
    this.host.connect();
    this.dueUs = this.board.chip.us;
  }

  unplug() {
    this.host.outQueue.length = 0;
    this.host.received.length = 0;
    this.reads = 0;
    this.host.reading = false;
    this.host.plug(false);
    this.board.chip.setPowered(false);
  }

  control(payload) {
    const [type, request] = payload;
    const [value, index, length] = [2, 4, 6].map((at) => payload.readUInt16LE(at));
    const result = this.host.request(type, request, value, index, length, payload.subarray(8));
    if (typeof result === 'string') return Buffer.of(1);
    return Buffer.concat([Buffer.of(0), result]);
  }

  /** A control transfer takes time of the board's, too, which these milliseconds make up for. */
  run(payload) {
    const [reads, count] = payload;
    for (let i = 0, at = 2; i < count; ++i) {
      const length = payload[at];
      this.host.outQueue.push(payload.subarray(at + 1, at + 1 + length));
      at += 1 + length;
    }
    this.reads = reads;
    this.host.reading = reads > 0;
    this.halted.clear();
    this.dueUs += 1000;
    if (this.board.chip.us < this.dueUs) this.board.chip.runUntil(this.dueUs);
    this.trace.update();
    this.peakA = Math.max(this.peakA, this.board.trueMa / 1000);
    const packets = this.host.received.splice(0).map(({ packet }) => Buffer.concat([Buffer.of(packet.length), packet]));
    const flags = (this.halted.has(0x81) ? 1 : 0) | (this.halted.has(0x01) ? 2 : 0);
    const events = Buffer.from(this.events);
    this.events = '';
    return Buffer.concat([Buffer.of(flags, this.host.outQueue.length, packets.length), ...packets, events]);
  }

  status() {
    const { board } = this;
    const { awake, closed } = board.pins();
    const { toggle, late, unarmed } = this.host.counts;
    const peak_a = this.peakA;
    this.peakA = board.trueMa / 1000;
    return Buffer.from(JSON.stringify({
      board_us: board.chip.us, awake, closed, set_point_age_us: this.trace.since(board.chip.us),
      current_a: board.readings.trueMa.map((ma) => ma / 1000), peak_a, frames_in: this.frames.in, frames_out: this.frames.out, bus_errors: toggle + late + unarmed,
    }));
  }

  respond(type, payload) {
    const none = Buffer.alloc(0);
    switch (type) {
      case 1: this.plug(); return none;
      case 2:
        this.unplug();
        this.trace.unpowered();
        return none;
      case 3: return this.control(payload);
      case 4: return this.run(payload);
      case 5: return this.status();
      default: throw new Error(`no request has the type ${type}`);
    }
  }
}

/** Takes whole messages from the bytes of a connection. Before the first one others are skipped: a machine that starts tests its ports. */
class Messages {
  constructor() {
    this.bytes = Buffer.alloc(0);
    this.begun = false;
  }

  add(bytes) { this.bytes = Buffer.concat([this.bytes, bytes]); }

  /** { type, payload }; undefined: incomplete. */
  next() {
    while (this.bytes.length >= kHead) {
      const length = this.bytes.readUInt16LE(2);
      const whole = kHead + length + kCrc;
      const possible = this.bytes[0] === kStart && length <= kMaxPayload;
      if (possible && this.bytes.length < whole) return undefined;
      if (possible && crc32(this.bytes.subarray(0, whole - kCrc)) === this.bytes.readUInt32LE(whole - kCrc)) {
        const message = { type: this.bytes[1], payload: this.bytes.subarray(kHead, kHead + length) };
        this.bytes = this.bytes.subarray(whole);
        this.begun = true;
        return message;
      }
      if (this.begun) throw new Error('a request has a wrong check sum');
      this.bytes = this.bytes.subarray(1);
    }
    return undefined;
  }
}

const [path] = process.argv.slice(2);
if (path === undefined) {
  console.error('usbip.mjs SOCKET');
  process.exit(64);
}
const served = new RemoteBoard();
const end = () => {
  served.board.close();
  process.exit();
};
const server = createServer((socket) => {
  server.close();
  const messages = new Messages();
  socket.on('data', (bytes) => {
    try {
      messages.add(bytes);
      for (let message = messages.next(); message; message = messages.next())
        socket.write(encode(message.type | kResponse, served.respond(message.type, message.payload)));
    } catch (error) {
      console.error(`usbip.mjs: ${error.stack}`);
      process.exitCode = 70;
      socket.end(encode(kError, Buffer.from(error.message)));
    }
  });
  socket.on('error', () => {});
  socket.on('close', end);
});
process.on('SIGTERM', end);
server.listen(path);
