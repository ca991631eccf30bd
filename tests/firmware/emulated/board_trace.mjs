// SPDX-License-Identifier: MIT
// What the board does, as JSON lines { event, us, since_set_point_us, awake, closed, fan, current_ma, peak_ma } in its own time; `peak_ma` is
// the largest current of each winding since the previous line, with its sign. Events: awake, asleep (the bridges); reset (by the watchdog);
// boot_loader (it has entered the ROM's); zero (no current, bridges asleep); unplugged; and those of `note`.

const kSetPoint = 0x01;
export const kNoCurrentMa = 100;

export class BoardTrace {
  /** `write` receives each line. */
  constructor(board, write) {
    this.board = board;
    this.write = write;
    this.setPointUs = undefined;
    this.peakMa = [0, 0, 0];
    this.awake = false;
    this.flowed = false;
    this.resets = 0;
    board.host.onOut = (packet, us) => { if (packet[2] === kSetPoint) this.setPointUs = us; };
  }

  /** Microseconds at `us` since the last set-point; null: there was none. */
  since(us) { return this.setPointUs === undefined ? null : us - this.setPointUs; }

  note(event, us = this.board.chip.us) {
    const { awake, closed, fan } = this.board.pins();
    const line = { event, us, since_set_point_us: this.since(us), awake, closed, fan, current_ma: this.board.readings.trueMa, peak_ma: this.peakMa };
    this.write(`${JSON.stringify(line)}\n`);
    this.peakMa = [0, 0, 0];
  }

  /** The cable, which feeds the processor, is pulled. */
  unpowered() {
    this.awake = false;
    this.note('unplugged');
  }

  /** To be called after each millisecond of the board. */
  update() {
    const { board } = this;
    this.peakMa = board.readings.trueMa.map((ma, k) => (Math.abs(ma) > Math.abs(this.peakMa[k]) ? ma : this.peakMa[k]));
    for (const { us, awake } of board.events.splice(0)) {
      this.awake = awake;
      // The time of the pin's edge, not of the end of the millisecond.
      this.note(awake ? 'awake' : 'asleep', us);
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
}
