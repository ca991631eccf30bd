// SPDX-License-Identifier: MIT
// hedgehogd on the emulated board: the real program, in a folder where hedgehog-simboard is simboard.mjs. They run in lock-step, so a busy
// machine slows both and delays neither.
import assert from 'node:assert/strict';
import { execFile, spawn } from 'node:child_process';
import { copyFileSync, existsSync, linkSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { setTimeout as pause } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { Ball } from '../../../clients/js/src/node.js';

const kSimboard = fileURLToPath(new URL('simboard.mjs', import.meta.url));
const kPollMs = 20;
/** Timeout of every wait in real time; assertions are in the ball's time. */
const kTimeoutMs = 500_000;

/** Waits until `condition()` returns a value; returns it. */
export async function eventually(what, condition) {
  for (const end = Date.now() + kTimeoutMs; Date.now() < end; await pause(kPollMs)) {
    const value = await condition();
    if (value) return value;
  }
  throw new Error(`never: ${what}`);
}

/** Waits for a time of the device, which on a busy machine passes more slowly than that of the host. */
export async function passed(ball, ms) {
  const { time_ns } = await ball.call('ping');
  await eventually(`${ms} ms have passed`, async () => (await ball.call('ping')).time_ns > time_ns + ms * 1e6);
}

function place(program, folder) {
  const to = join(folder, 'hedgehogd');
  try {
    linkSync(program, to);
  } catch {
    copyFileSync(program, to);
  }
  writeFileSync(join(folder, 'hedgehog-simboard'), `#!/bin/sh\nexec '${process.execPath}' '${kSimboard}' "$@"\n`, { mode: 0o755 });
  return to;
}

export class DaemonOnBoard {
  /** `config` in addition to the simulator's process, `devices`: name to device file, `speed`: at most so many times real time. */
  static async start({ config = {}, devices = {}, speed = 10, programs = process.env.HEDGEHOG_PROGRAMS } = {}) {
    const daemon = new DaemonOnBoard();
    daemon.programs = programs;
    daemon.folder = mkdtempSync(join(programs, 'emulated-'));
    const path = (...below) => join(daemon.folder, ...below);
    daemon.traceFile = path('trace');
    daemon.controlFile = path('control');
    mkdirSync(path('hedgehog', 'devices.d'), { recursive: true });
    for (const [name, file] of Object.entries(devices)) writeFileSync(path('hedgehog', 'devices.d', `${name}.json`), JSON.stringify(file));
    const { simulator, ...others } = config;
    const all = { http: { listen: null }, ...others, simulator: { ...simulator, process: true } };
    writeFileSync(path('hedgehog', 'hedgehogd.json'), JSON.stringify(all));
    daemon.environment = {
      ...process.env, HEDGEHOG_PATIENCE_MS: '60000', HOME: daemon.folder, XDG_CONFIG_HOME: daemon.folder, XDG_STATE_HOME: path('state'),
      XDG_RUNTIME_DIR: daemon.folder, HEDGEHOG_SIMBOARD_TRACE: daemon.traceFile, HEDGEHOG_BOARD_CONTROL: daemon.controlFile,
    };
    daemon.child = spawn(place(join(programs, 'daemon', 'hedgehogd'), daemon.folder),
      ['--simulate', '--speed', String(speed), '--listen', '127.0.0.1:0'],
      { env: daemon.environment, stdio: ['ignore', 'pipe', 'pipe'] });
    // The board, which writes to its trace until its end, keeps the daemon's standard error open.
    daemon.child.on('close', () => { daemon.hasEnded = true; });
    daemon.log = '';
    daemon.child.stderr.on('data', (bytes) => { daemon.log += bytes; });
    try {
      await daemon.connect();
    } catch (error) {
      await daemon.close();
      throw error;
    }
    return daemon;
  }

  async connect() {
    for await (const line of createInterface({ input: this.child.stdout })) {
      this.address = /^listening on (127\.0\.0\.1:\d+)$/.exec(line)?.[1];
      if (this.address) break;
    }
    if (!this.address) throw new Error(`hedgehogd ended: ${this.log}`);
    this.environment.HEDGEHOG_ADDRESS = this.address;
    this.ball = await Ball.connect({ address: this.address, timeoutMs: kTimeoutMs });
  }

  /** The board's events so far (simboard.mjs). */
  trace() {
    if (!existsSync(this.traceFile)) return [];
    return readFileSync(this.traceFile, 'utf8').split('\n').slice(0, -1).map((line) => JSON.parse(line));
  }

  /** Sends one line to the board; returns the trace of its execution. */
  async control(line) {
    const before = this.trace().length;
    writeFileSync(`${this.controlFile}.new`, `${line}\n`);
    renameSync(`${this.controlFile}.new`, this.controlFile);
    await eventually(`${line} is done`, () => !existsSync(this.controlFile));
    return this.trace().slice(before);
  }

  state(expected) {
    return eventually(`the ball is ${expected}`, async () => {
      const status = await this.ball.status();
      return status.state === expected && status;
    });
  }

  /** Runs a command of hedgehogctl: { code, out, err }. */
  ctl(...words) {
    return new Promise((resolve) => {
      execFile(join(this.programs, 'clients', 'ctl', 'hedgehogctl'), words, { env: this.environment, cwd: this.folder },
        (error, out, err) => resolve({ code: error ? error.code : 0, out, err }));
    });
  }

  /** The output of a line of a guide, in a shell that finds hedgehogctl; must succeed. */
  shell(line) {
    const PATH = `${join(this.programs, 'clients', 'ctl')}:${process.env.PATH}`;
    return new Promise((resolve, reject) => {
      execFile('sh', ['-ec', line], { env: { ...this.environment, PATH }, cwd: this.folder },
        (error, out, err) => (error ? reject(new Error(`${line}: ${out}${err}`)) : resolve(out)));
    });
  }

  /** Stops the daemon and waits until the board, which then makes itself safe, has ended too; returns its whole trace. */
  async stop(signal = 'SIGTERM') {
    await this.end(signal);
    assert.equal(this.trace().at(-1)?.event, 'exit', this.log);
    return this.trace();
  }

  async end(signal) {
    this.child.kill(signal);
    await eventually('daemon and board end', () => this.hasEnded);
  }

  async close() {
    this.ball?.close();
    await this.end('SIGKILL');
    rmSync(this.folder, { recursive: true, force: true });
  }
}
