// SPDX-License-Identifier: MIT
// Replaces hedgehog-simboard by the emulated board, behind the socket that hedgehogd passes to its simulated board, in lock-step with it
// (hedgehogd --simulate --speed N, simulator.process). Takes the arguments of hedgehog-simboard. The USB host does the operating
// system's part: it enumerates and forwards packets between daemon and board.
//
// --trace F: the lines of board_trace.mjs; further events: start; lost (the host has disconnected); unplugged, plugged; done (control);
// exit.
// HEDGEHOG_BOARD_CONTROL=F: a file whose lines are executed, then it is removed: `alone MS` (the board runs on without its host, as
// when that is frozen or busy), `unplug MS` (of USB, for MS), `hang` (the program).
import { appendFileSync, closeSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { Board } from './board.mjs';
import { BoardTrace, kNoCurrentMa } from './board_trace.mjs';

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
    const file = option('--trace');
    this.trace = new BoardTrace(this.board, (line) => { if (file !== undefined) appendFileSync(file, line); });
    this.control = process.env.HEDGEHOG_BOARD_CONTROL;
    this.host = this.board.host;
    this.ms = 0;
  }

  millisecond() {
    this.board.run(1);
    this.trace.update();
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
    this.trace.unpowered();
    this.alone(ms);
    this.trace.note('plugged');
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
    this.trace.note('done');
    rmSync(this.control);
  }

  /** The operating system detects the board when it is plugged in and after its reset. */
  enumerate() {
    if (this.host.configured || !this.host.connected) return;
    this.host.enumerate();
  }

  serve() {
    this.trace.note('start');
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
    this.trace.note('lost');
    this.alone(0);
    this.host.reading = false;
    const end = this.board.chip.us + kShutdownMs * 1000;
    do this.millisecond();
    while (this.board.chip.us < end && (this.trace.awake || this.board.trueMa > kNoCurrentMa));
    this.trace.note('exit');
    this.board.close();
  }
}

const served = new ServedBoard();
served.serve();
served.shutDown();
