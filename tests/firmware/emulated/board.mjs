// SPDX-License-Identifier: MIT
// The reference board around an emulated microcontroller: its pins drive the simulator's ball, whose readings return through a converter on
// SPI, fault lines and a tach.
import { Chip, kPhaseCorrect } from './chip.mjs';
import { flashImage } from './elf.mjs';
import { arm, setPoint, telemetry } from './frames.mjs';
import { Plant } from './plant.mjs';
import { UsbHost } from './usb_host.mjs';

// firmware/README.md
const kDir = 3;
const kSleep = 6;
const kFault = 7;
const kTach = 11;
const kSwitch = 12;
const kSelect = 17;
const kSio = 5;
const kPwm = 4;
const kCompare = 0x0c;
const kFanTop = 4999;
const kCyclesPerUs = 125;
/** Of the address map of rp2040js. */
const kTimer = 0x40054;
const kAlarm = 0x10;

const kPlantUs = 1000;
const kLateUs = 1200;
/** A longer pause between two conversions starts a millisecond of the firmware. */
const kPauseUs = 300;
/** MCP3208 at 3.3 V, interpolated from DS21298E. */
const kMaxSpiHz = 1.26e6;
const kDeselectedUs = 0.5;
const kWordBits = 10;
/** Its control register, but for the divider: mode 0. */
const kTenBits = kWordBits - 1;

const kSafePins = { pwm: [0, 0, 0], direction: 0, awake: false, closed: false, fan: kFanTop };

export class Board {
  constructor(elf = process.env.HEDGEHOG_FIRMWARE_ELF, options = {}) {
    this.plant = new Plant(options.plant);
    this.host = new UsbHost();
    this.events = []; // changes of SLP: { us, awake }
    this.applied = []; // compare values of winding x: { us, value }, at the end of the PWM period before them
    this.ticks = []; // start of the rules in each millisecond of the firmware, us
    this.busiestCycles = 0; // of the firmware's milliseconds, from one conversion to the next
    this.shownCurrent = undefined; // converter code of winding x's amplifier in place of its current
    this.shownShunt = undefined; // the same of the supply's shunt
    this.spiPauseClocks = 1; // of the converter's bus, between two words
    this.converterResponds = true; // false: its line is low, as by the pull-down of the microcontroller
    this.slowestPwmUs = 0; // from the start of the rules to their compare values
    this.onSample = () => {}; // called with each winding's current that is converted: { winding, offCentreUs, onTimeUs }
    this.onTick = () => {}; // called with the readings that the firmware is about to convert
    this.onApply = () => {}; // called when the firmware writes its compare values
    this.readings = this.plant.step(kSafePins);
    this.chip = new Chip(flashImage(elf), { ...options, attach: (mcu, chip) => this.attach(mcu, chip) });
  }

  attach(mcu, chip) {
    this.chip = chip;
    this.mcu = mcu;
    chip.pinsNow = () => this.pins();
    this.selectedUs = -1e9;
    this.measuring = false;
    this.busyBefore = undefined;
    this.host.attach(mcu, chip);
    this.attachConverter();
    let awake = false;
    mcu.gpio[kSleep].addListener(() => {
      if (this.high(kSleep) === awake) return;
      awake = !awake;
      this.events.push({ us: chip.us, awake });
    });
    const slice = mcu.pwm.channels[0];
    const write = slice.writeRegister.bind(slice);
    slice.writeRegister = (offset, value) => {
      if (offset === kCompare) {
        if (this.ticks.length > 0) this.slowestPwmUs = Math.max(this.slowestPwmUs, chip.us - this.ticks.at(-1));
        this.onApply();
      }
      write(offset, value);
    };
    const wrap = slice.updateDoubleBuffered.bind(slice);
    slice.updateDoubleBuffered = () => {
      if (slice.ccUpdated) this.applied.push({ us: chip.us, value: slice.cc & 0xffff });
      wrap();
    };
    // After the conversions, the rules begin with the alarm of the next millisecond.
    const timer = mcu.peripherals[kTimer];
    const writeTimer = timer.writeUint32.bind(timer);
    timer.writeUint32 = (offset, value) => {
      if (offset === kAlarm && this.measuring) {
        this.measuring = false;
        this.ticks.push(chip.us);
      }
      writeTimer(offset, value);
    };
    this.late = mcu.clock.createAlarm(() => this.stepPlant(kPlantUs));
    this.late.schedule(kPlantUs * 1000);
    this.tachHigh = true;
    this.tach = mcu.clock.createAlarm(() => this.turnFan());
    this.tach.schedule(1e6);
    this.faultsShown = undefined;
    this.showFaults();
  }

  /** A pin with the board's resistors: low when it is not driven. */
  high(pin) {
    const gpio = this.mcu.gpio[pin];
    return gpio.outputEnable && gpio.functionSelect === kSio && gpio.outputValue;
  }

  pins() {
    const { gpio, pwm } = this.mcu;
    const compare = (pin, alarm) => (gpio[pin].functionSelect === kPwm && pwm.channels[pin >> 1].timer.enable ? alarm.target : undefined);
    return {
      pwm: [
        compare(0, pwm.channels[0].alarmA) ?? 0, compare(1, pwm.channels[0].alarmB) ?? 0, compare(2, pwm.channels[1].alarmA) ?? 0,
      ],
      direction: [0, 1, 2].reduce((bits, k) => bits | (this.high(kDir + k) ? 1 << k : 0), 0),
      awake: this.high(kSleep),
      closed: this.high(kSwitch),
      fan: compare(10, pwm.channels[5].alarmA) ?? kFanTop, // a fan whose line is open runs at full speed
    };
  }

  stepPlant(untilNextUs) {
    this.readings = this.plant.step(this.pins());
    this.showFaults();
    this.late.schedule(untilNextUs * 1000);
  }

  showFaults() {
    if (this.faultsShown === this.readings.faultsLow) return;
    this.faultsShown = this.readings.faultsLow;
    for (let k = 0; k < 3; ++k) this.mcu.gpio[kFault + k].setInputValue(((this.faultsShown >> k) & 1) === 0);
  }

  turnFan() {
    const period = this.readings.tachUs;
    this.tach.schedule((period > 0 ? period / 2 : 1000) * 1000);
    if (period === 0) return;
    this.tachHigh = !this.tachHigh;
    this.mcu.gpio[kTach].setInputValue(this.tachHigh);
  }

  attachConverter() {
    const { mcu, chip } = this;
    const spi = mcu.spi[0];
    let words = [];
    let selected = true;
    let deselectedUs = -1;
    mcu.gpio[kSelect].addListener(() => {
      if (this.high(kSelect) !== selected) return;
      selected = !selected;
      words = [];
      if (!selected) {
        deselectedUs = chip.us;
        return;
      }
      if (chip.us - deselectedUs < kDeselectedUs) chip.warnings.push('the converter is selected again too soon');
      if (chip.us - this.selectedUs > kPauseUs) {
        this.measuring = true; // until the rules begin
        if (this.busyBefore !== undefined) this.busiestCycles = Math.max(this.busiestCycles, chip.busyCycles - this.busyBefore);
        this.busyBefore = chip.busyCycles;
        this.stepPlant(kLateUs);
        this.onTick(this.readings);
      }
      this.selectedUs = chip.us;
    });
    let response = 0;
    const done = mcu.clock.createAlarm(() => spi.completeTransmit(response));
    spi.onTransmit = (value) => {
      if (this.high(kSelect) || (spi.control0 & 0xff) !== kTenBits || !spi.enabled || spi.clockFrequency > kMaxSpiHz)
        chip.warnings.push('the converter is not spoken to as its data sheet says');
      words.push(value);
      const clockUs = 1e6 / spi.clockFrequency;
      if (words.length === 1) this.reportSample((value >> 4) & 7, 7.5 * clockUs);
      response = this.converterResponds ? this.converterWord(words) : 0;
      // RP2040 data sheet 4.4.3.10: the first edge after a clock; the select pin, which is not connected, is high for a clock between words.
      const clocks = kWordBits + 1 + (words.length > 1 ? this.spiPauseClocks : 0);
      done.schedule((1000 * clocks * clockUs) | 0);
    };
  }

  /** A conversion begins: the sampling of `input` ends `afterUs` from now, with the falling edge of clock 7 (DS21298E, figure 6-1). */
  reportSample(input, afterUs) {
    if (input > 2) return;
    const { timer, csr } = this.mcu.pwm.channels[input >> 1];
    const compare = this.pins().pwm[input];
    // Around the counter's 0, or from it on.
    const [middle, onTime] = csr & kPhaseCorrect ? [0, 2 * compare] : [compare / 2, compare];
    const periodUs = (timer.top + 1) / kCyclesPerUs;
    const us = ((timer.counter - middle) / kCyclesPerUs + afterUs + periodUs) % periodUs;
    this.onSample({ winding: input, offCentreUs: us < periodUs / 2 ? us : us - periodUs, onTimeUs: onTime / kCyclesPerUs });
  }

  /** DS21298E, figure 6-1: after a zero, the start bit, single ended, the input; undefined bits are 1. */
  converterWord(words) {
    const [request] = words;
    if ((request & 0x38f) !== 0x180) this.chip.warnings.push('no single ended conversion');
    const { current, shunt, supply, ntc } = this.readings;
    const value = [this.shownCurrent ?? current[0], current[1], current[2], this.shownShunt ?? shunt, supply, ...ntc][(request >> 4) & 7];
    return words.length === 1 ? 0x3f8 | (value >> 10) : value & 0x3ff;
  }

  /** Milliamperes of the true current vector. */
  get trueMa() { return Math.hypot(...this.readings.trueMa); }

  /** Calls `what` once, `us` microseconds from now. */
  after(us, what) {
    if (us <= 0) what();
    else this.mcu.clock.createAlarm(what).schedule(us * 1000);
  }

  run(ms, stop) { return this.chip.run(ms * 1000, stop); }

  close() { this.plant.close(); }
}

/** A host that sends a set-point in each frame of the bus. */
export class Driver {
  constructor(board) {
    this.board = board;
    this.sequence = 0;
    this.armCount = 0;
    this.target = { enable: false };
    this.sending = true;
    this.last = undefined;
    this.first = true;
    board.host.onFrame = () => {
      if (!this.sending) return;
      board.host.outQueue.push(setPoint(++this.sequence, this.target));
      // The boost lasts one millisecond, as the daemon's does.
      if (this.target.boost) this.target = { ...this.target, boost: undefined };
    };
    board.host.onIn = (packet) => { this.last = telemetry(packet); };
  }

  enumerate() {
    const found = this.board.host.enumerate();
    this.board.run(5);
    return found;
  }

  arm() {
    this.armCount = (this.armCount + 1) & 255;
    this.board.host.outQueue.push(arm(++this.sequence, this.armCount));
    this.board.run(10);
  }

  /** Enumerated, armed and driving: a holding duty without a boost takes some ms to reach its current. */
  drive(duty, ms = 60) {
    this.enumerate();
    this.arm();
    this.target = { enable: true, duty };
    this.board.run(ms);
  }
}
