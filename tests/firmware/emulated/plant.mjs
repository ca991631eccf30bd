// SPDX-License-Identifier: MIT
// The simulator's ball and electronics (plant_main.cpp) as a process, with one line per request and response.
import { execFileSync, spawn } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readSync, rmSync, writeSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export class Plant {
  /** `words` are its arguments; `socket` is the descriptor of a host, passed on as descriptor 3. */
  constructor({ words = [], socket = undefined, program = process.env.HEDGEHOG_FIRMWARE_PLANT } = {}) {
    // Named pipes, because those of spawn cannot be read synchronously.
    this.folder = mkdtempSync(join(tmpdir(), 'hedgehog-plant-'));
    const [to, from] = ['to', 'from'].map((name) => join(this.folder, name));
    execFileSync('mkfifo', [to, from]);
    const script = 'program=$1 to=$2 from=$3; shift 3; exec "$program" "$@" <"$to" >"$from"';
    this.child = spawn('sh', ['-c', script, 'sh', program, to, from, ...words], {
      stdio: ['ignore', 'ignore', 'inherit', ...(socket === undefined ? [] : [socket])],
    });
    this.child.unref();
    this.input = openSync(to, 'w');
    this.output = openSync(from, 'r');
    this.buffer = Buffer.alloc(4096);
  }

  command(line) {
    writeSync(this.input, `${line}\n`);
    let length = 0;
    do {
      const got = readSync(this.output, this.buffer, length, this.buffer.length - length, null);
      if (got === 0) throw new Error(`the plant ended at: ${line}`);
      length += got;
    } while (this.buffer[length - 1] !== 10);
    return this.buffer.toString('latin1', 0, length - 1);
  }

  /** One millisecond with these pin values; returns the converter's readings after it and the true values. */
  step({ pwm, direction, awake, closed, fan }) {
    const n = this.command(`step ${pwm.join(' ')} ${direction} ${awake ? 1 : 0} ${closed ? 1 : 0} ${fan}`).split(' ').map(Number);
    return {
      current: n.slice(0, 3), shunt: n[3], supply: n[4], ntc: n.slice(5, 8), faultsLow: n[8], tachUs: n[9],
      trueMa: n.slice(10, 13), fan: n[13] / 1000,
    };
  }

  /** Packets of the host up to a set-point, waiting at most `timeoutMs`; undefined: the host has disconnected. */
  receive(timeoutMs) {
    const [state, begun, ...packets] = this.command(`host ${timeoutMs}`).split(' ');
    if (state === 'closed') return undefined;
    return { begun: begun === '1', packets: packets.map((hex) => Buffer.from(hex, 'hex')) };
  }

  respond(ms, packets) { this.command(['answer', ms, ...packets.map((packet) => Buffer.from(packet).toString('hex'))].join(' ')); }

  close() {
    closeSync(this.input);
    closeSync(this.output);
    rmSync(this.folder, { recursive: true });
  }
}
