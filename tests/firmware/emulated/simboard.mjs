// SPDX-License-Identifier: MIT
// Replaces hedgehog-simboard by the emulated board, behind the socket that hedgehogd passes to its simulated board, in lock-step with it
// (hedgehogd --simulate --speed N, simulator.process). Takes the arguments of hedgehog-simboard. The USB host does the operating
// system's part: it enumerates and forwards packets between daemon and board.
//
// --trace F: JSON lines { event, us, since_set_point_us, awake, closed, fan, current_ma, peak_ma } in the board's own time; `peak_ma` is
// the largest current of each winding since the previous line, with its sign. Events: start; awake, asleep (the bridges); reset (by the
// watchdog); boot_loader (it has entered the ROM's); lost (the host has disconnected); zero (no current, bridges asleep); unplugged, plugged; done (control); exit.
// HEDGEHOG_BOARD_CONTROL=F: a file whose lines are executed, then it is removed: `alone MS` (the board runs on without its host, as
// when that is frozen or busy), `unplug MS` (of USB, for MS), `hang` (the program).
import { appendFileSync, closeSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { Board } from './board.mjs';

const kSetPoint = 0x01;
const kNoCurrentMa = 100;
const kMaxQueued = 16;
const kShutdownMs = 5000;
const kPollMs = 20;
const kTicksPerPoll = 20;

const words = process.argv.slice(2);
const option = (name) => (words.includes(name) ? words[words.indexOf(name) + 1] : undefined);
if (!words.includes('--in-step') || option('--fd') === undefined) {
  console.error('the emulated board keeps step with its host: hedgehogd --simulate --speed N with simulator.process');
  process.exit(64);
}

class ServedBoard {
  constructor() {
    const socket = Number(option('--fd'));
    const plantWords = words.map((word, i) => (words[i - 1] === '--fd' ? '3' : word));
    this.board = new Board(undefined, { plant: { words: plantWords, socket } });
    closeSync(socket);
    this.trace = option('--trace');
    this.control = process.env.HEDGEHOG_BOARD_CONTROL;
    this.host = this.board.host;
    this.setPointUs = undefined;
    this.peakMa = [0, 0, 0];
    this.awake = false;
    this.flowed = false;
    this.resets = 0;
    this.ms = 0;
    this.host.onOut = (packet, us) => { if (packet[2] === kSetPoint) this.setPointUs = us; };
  }

  note(event, more = {}) {
    if (this.trace === undefined) return;
    const { us } = this.board.chip;
    const { awake, closed, fan } = this.board.pins();
    const current_ma = this.board.readings.trueMa;
    const since_set_point_us = this.setPointUs === undefined ? null : us - this.setPointUs;
    appendFileSync(this.trace, `${JSON.stringify({ event, us, since_set_point_us, awake, closed, fan, current_ma, peak_ma: this.peakMa, ...more })}\n`);
    this.peakMa = [0, 0, 0];
  }

  millisecond() {
    const { board } = this;
    board.run(1);
    this.peakMa = board.readings.trueMa.map((ma, k) => (Math.abs(ma) > Math.abs(this.peakMa[k]) ? ma : this.peakMa[k]));
    for (const { us, awake } of board.events.splice(0)) {
      this.awake = awake;
      // The time of the pin's edge, not of the end of the millisecond.
      this.note(awake ? 'awake' : 'asleep', { us, since_set_point_us: this.setPointUs === undefined ? null : us - this.setPointUs });
    }
    if (board.chip.resets !== this.resets) {
      this.resets = board.chip.resets;
      this.awake = false;
      this.note(board.chip.bootLoader ? 'boot_loader' : 'reset');
    }
    if (board.trueMa > kNoCurrentMa) this.flowed = true;
    else if (this.flowed && !this.awake) {
      this.flowed = false;
      this.note('zero');
    }
    board.ticks.length = 0;
    board.applied.length = 0;
  }

  alone(ms) {
    this.host.outQueue.length = 0;
    const { reading } = this.host;
    this.host.reading = false;
    for (let i = 0; i < ms; ++i) this.millisecond();
    this.host.reading = reading;
  }

  /** The processor is fed by the cable. */
  unplug(ms) {
    this.host.plug(false);
    this.board.chip.setPowered(false);
    this.awake = false;
    this.note('unplugged');
    this.alone(ms);
    this.note('plugged');
    this.host.plug(true);
    this.board.chip.setPowered(true);
  }

  /** Executes the lines of a test, once the file is complete. */
  runCommands() {
    if (!this.control || !existsSync(this.control)) return;
    const lines = readFileSync(this.control, 'utf8').trim().split('\n');
    for (const line of lines) {
      const [command, value] = line.split(' ');
      if (command === 'alone') this.alone(Number(value));
      else if (command === 'unplug') this.unplug(Number(value));
      else if (command === 'hang') this.board.chip.hang();
      else throw new Error(`${this.control}: ${line}`);
    }
    this.note('done');
    rmSync(this.control);
  }

  /** The operating system detects the board when it is plugged in and after its reset. */
  enumerate() {
    if (this.host.configured || !this.host.connected) return;
    this.host.enumerate();
  }

  serve() {
    this.note('start');
    for (let tick = 0; ; ++tick) {
      const received = this.board.plant.receive(kPollMs);
      if (received === undefined) return;
      if (!received.begun || tick % kTicksPerPoll === 0) this.runCommands();
      this.host.outQueue.push(...received.packets);
      if (!received.begun) continue;
      this.enumerate();
      this.host.outQueue.splice(0, this.host.outQueue.length - kMaxQueued);
      this.millisecond();
      this.board.plant.respond(++this.ms, this.host.received.splice(0).map(({ packet }) => packet));
    }
  }

  /** The process that used the board has ended; the operating system still runs. */
  shutDown() {
    this.note('lost');
    this.alone(0);
    this.host.reading = false;
    const end = this.board.chip.us + kShutdownMs * 1000;
    do this.millisecond();
    while (this.board.chip.us < end && (this.awake || this.board.trueMa > kNoCurrentMa));
    this.note('exit');
    this.board.close();
  }
}

const served = new ServedBoard();
served.serve();
served.shutDown();
