// SPDX-License-Identifier: MIT
// The board core of the host's build in parallel with the firmware: it receives the same packets and the same converter values in the same
// millisecond, and must return the same frames.

/** The firmware measures the tach itself. */
const kFanRpmAt = 36;
const kCrcAt = 60;

export class CoreMirror {
  /** REQUIRES: the board has not run yet. */
  constructor(board) {
    this.board = board;
    this.differences = [];
    this.compared = 0;
    this.modes = new Set();
    this.faults = 0;
    this.packets = [];
    this.frames = new Map();
    this.turn = 0;
    this.ntc = [0, 0, 0];
    this.complete = false;
    board.plant.command('core');
    board.host.onReceived = (packet) => this.packets.push(Buffer.from(packet).toString('hex'));
    // A packet received during the conversions still counts in this millisecond.
    board.onTick = (readings) => { this.readings = readings; };
    board.onApply = () => {
      if (this.readings) this.step(this.readings);
      this.readings = undefined;
    };
    const { onIn } = board.host;
    board.host.onIn = (packet, us) => {
      onIn(packet, us);
      this.compare(Buffer.from(packet));
    };
  }

  step(readings) {
    // firmware/converter: one thermistor a millisecond, in turn.
    this.ntc[this.turn] = readings.ntc[this.turn];
    this.turn = (this.turn + 1) % 3;
    const converted = this.turn === 0;
    this.complete ||= converted;
    const ntc = this.ntc.map((value, k) => (this.complete || k < this.turn ? value : this.ntc[0]));
    const { current, shunt, supply, faultsLow } = readings;
    const frame = Buffer.from(this.board.plant.command(
      ['frame', ...current, shunt, supply, ...ntc, converted ? 1 : 0, faultsLow, 0, ...this.packets].join(' ')), 'hex');
    this.packets = [];
    this.frames.set(frame.readUInt32LE(4), frame);
  }

  compare(frame) {
    const sequence = frame.readUInt32LE(4);
    const expected = this.frames.get(sequence);
    this.frames.delete(sequence);
    ++this.compared;
    this.modes.add(frame[39]);
    this.faults |= frame.readUInt16LE(42);
    const shown = (bytes) => Buffer.from(bytes.subarray(0, kCrcAt)).fill(0, kFanRpmAt, kFanRpmAt + 2).toString('hex');
    if (expected === undefined || shown(frame) !== shown(expected))
      this.differences.push({ sequence, board: shown(frame), host: expected && shown(expected) });
  }
}
