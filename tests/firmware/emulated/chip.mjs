// SPDX-License-Identifier: MIT
// An RP2040 (rp2040js) with a run loop of its own, booted as by its ROM. Deviations of rp2040js that matter for this board are corrected or
// reported as errors here: README.md.
import { createRequire } from 'node:module';
import { crc32Mpeg2 } from './elf.mjs';

const require = createRequire(`${process.env.HEDGEHOG_NODE_MODULES}/`);
const { Simulator } = require('rp2040js');

const kNanosPerCycle = 8; // 125 MHz
const kRomMs = 4; // approximate time of ROM and crystal start-up
const kBoot2At = 0x20041f00; // end of SRAM, to which the ROM copies the second stage
const kStackBytes = 4096;
const kPaint = 0xa5;
const kHang = [0xfe, 0xe7]; // b .

// The ROM: its function table, and two of the functions.
const kRomEnd = 0x4000;
const kRomTable = 0x7a;
const kRomLookup = 0x1d;
const kRomUsbBoot = 0x2591;

const kSram = 0x20000000;
const kUsbMemory = 0x50100000;
const kUsbBuffers = 0x100;
const kSpiStatus = 0x0c;
const kSpiReceived = 1 << 2;
const kMaxPollingCycles = 12;

const kSysInfo = 0x40000000;
const kResets = 0x4000c000;
const kWatchdog = 0x40058000;
const kVregAndChipReset = 0x40064000;
const kBrownOut = 4;
const kSsi = 0x18000000;
const kIoQspi = 0x40018000;
/** Bits of RESETS. */
const kResetOf = new Map([
  [0x4004c, 0], [0x40014, 5], [0x4001c, 8], [0x40028, 12], [0x4002c, 13], [0x40050, 14], [0x4003c, 16], [0x40000, 19], [0x40054, 21], [0x50110, 24],
]);

function sleepForGood(core) {
  core.enabledInterrupts = 0;
  core.waiting = true;
}

const kUsbReset = 1 << 24;
const kPwmControl = 0x00;
const kPwmCounter = 0x08;
/** Of a PWM slice's control register. */
export const kPhaseCorrect = 2;

const slot = (address) => (address >>> 14) << 2;

export class Chip {
  /** `attach(mcu, chip)` is called at every boot. */
  constructor(image, { attach, flashId = [0xe4, 0x62, 0x8c, 0x11, 0x27, 0x5a, 0x3f, 0x2b], revision = 2 }) {
    this.image = image;
    this.attach = attach;
    this.flashId = flashId;
    this.revision = revision; // 1: B0 and B1, 2: B2
    this.baseNanos = 0;
    this.resets = 0;
    this.powered = true;
    this.supplyChanged = false;
    this.warnings = [];
    this.busyCycles = 0; // since construction
    this.visited = new Uint8Array(0x42000 >> 1); // executed halfwords of SRAM; only the program's first steps run elsewhere
    this.visitedInFlash = new Uint8Array(256);
    this.boot();
  }

  get nanos() { return this.baseNanos + this.clock.nanosCounter; }
  get us() { return this.nanos / 1000; }

  boot() {
    const { rp2040: mcu, clock } = new Simulator();
    Object.assign(this, { mcu, clock, core: mcu.core, resetDue: false });
    const warn = (name, text) => this.warnings.push(`${name}: ${text}`);
    mcu.logger = { debug() {}, info() {}, warn, error: warn };
    mcu.onBreak = (code) => warn('core', `bkpt ${code}`);
    mcu.peripherals[slot(kSysInfo)].readUint32 = () => ((this.revision << 28) | 0x2927) >>> 0;
    this.holdResets();
    this.replaceFlash();
    this.replaceRegulator();
    this.fixCore();
    this.fixPwm();
    this.shortenAccesses();
    this.watchPolling();
    const watchdog = mcu.peripherals[slot(kWatchdog)];
    watchdog.tickEnable = false; // rp2040js: as if the firmware had enabled it
    watchdog.onWatchdogTrigger = () => {
      watchdog.alarm.enable = false; // otherwise it fires repeatedly at this instant
      this.resetDue = true;
    };
    mcu.flash.set(this.image);
    new DataView(mcu.bootrom.buffer).setUint16(0x14, kRomTable, true);
    new DataView(mcu.bootrom.buffer).setUint16(0x18, kRomLookup, true);
    this.enterSecondStage();
    this.attach(mcu, this);
    clock.tick(kRomMs * 1e6);
    // The boot loader's own USB is not emulated: the pins stay as after reset. So they do without a supply.
    if (this.bootLoader || !this.powered) sleepForGood(this.core);
  }

  /** The ROM's steps: check, copy, jump. */
  enterSecondStage() {
    const { mcu, core } = this;
    const stage = mcu.flash.subarray(0, 256);
    const view = new DataView(stage.buffer, 0, 256);
    if (crc32Mpeg2(stage.subarray(0, 252)) !== view.getUint32(252, true)) throw new Error('the second stage has a wrong check sum');
    mcu.sram.fill(kPaint, 0, kStackBytes);
    mcu.sram.set(stage, kBoot2At - 0x20000000);
    core.SP = kBoot2At;
    core.LR = 0;
    core.PC = kBoot2At;
  }

  /** RP2040 data sheet 2.8.3: functions that the firmware may call. */
  runRom(entry) {
    const { core } = this;
    const [first, second] = core.registers;
    if (entry === kRomLookup) {
      const known = first === kRomTable && second === ('U'.charCodeAt(0) | ('B'.charCodeAt(0) << 8));
      core.registers[0] = known ? kRomUsbBoot : 0;
      core.PC = core.LR & ~1;
    } else if (entry === kRomUsbBoot) {
      this.bootLoader = { lamp: first, disabled: second, pinsBefore: this.pinsNow?.() };
      this.resetDue = true;
    } else {
      this.warnings.push(`no function of the ROM at ${entry.toString(16)}`);
      core.PC = core.LR & ~1;
    }
  }

  /** Blocks start in reset, and an access to a block in reset is a warning. */
  holdResets() {
    const { mcu } = this;
    const resets = mcu.peripherals[slot(kResets)];
    let held = 0x1ffffff;
    Object.defineProperty(resets, 'reset', {
      get: () => held,
      set: (bits) => {
        if (bits & ~held & kUsbReset) this.resetUsb();
        held = bits;
      },
    });
    Object.defineProperty(resets, 'reset_done', { get: () => ~resets.reset & 0x1ffffff });
    const find = mcu.findPeripheral.bind(mcu);
    mcu.findPeripheral = (address) => {
      const bit = kResetOf.get(slot(address));
      if (bit !== undefined && resets.reset & (1 << bit)) this.warnings.push(`${address.toString(16)} is in reset`);
      return find(address);
    };
  }

  /** The registers of the USB controller, without its memory; rp2040js keeps them. */
  resetUsb() {
    const usb = this.mcu.usbCtrl;
    for (const name of ['addrEndp', 'mainCtrl', 'intRaw', 'intEnable', 'intForce', 'sieStatus', 'buffStatus', 'sieCtrl', 'epStallArm']) usb[name] = 0;
    usb.checkInterrupts();
    this.onUsbReset?.();
  }

  /** The flash chip behind SSI: rp2040js provides plain reading, this its unique id. */
  replaceFlash() {
    const { mcu } = this;
    const registers = new Map();
    const store = (peripheral) => {
      peripheral.readUint32 = (offset) => registers.get(offset) ?? 0;
      peripheral.writeUint32 = (offset, value) => registers.set(offset, value);
    };
    let sent = [];
    const responses = [];
    const qspi = mcu.peripherals[slot(kIoQspi)];
    store(qspi);
    qspi.writeUint32 = () => { sent = []; };
    const ssi = mcu.peripherals[slot(kSsi)];
    const values = new Map();
    ssi.readUint32 = (offset) => {
      if (offset === 0x28) return 0x06 | (responses.length > 0 ? 8 : 0);
      return offset === 0x60 ? responses.shift() ?? 0 : values.get(offset) ?? 0;
    };
    ssi.writeUint32 = (offset, value) => {
      values.set(offset, value);
      if (offset !== 0x60) return;
      sent.push(value & 255);
      responses.push(sent[0] === 0x4b && sent.length > 5 ? this.flashId[sent.length - 6] ?? 0xff : 0xff);
    };
  }

  /** Regulator and brown-out detector of the core, with their values in reset (2.10.6). */
  replaceRegulator() {
    const values = new Map([[0, 0xb1], [kBrownOut, 0x91]]);
    const block = this.mcu.peripherals[slot(kVregAndChipReset)];
    block.readUint32 = (offset) => values.get(offset) ?? 0;
    block.writeUint32 = (offset, value) => values.set(offset, value);
    this.brownOut = () => values.get(kBrownOut);
  }

  /** The core's supply falls to `volts` for a moment: a reset, if the detector's threshold is above that. */
  sagCore(volts) {
    const threshold = 0.473 + 0.043 * ((this.brownOut() >> 4) & 15);
    if (this.brownOut() & 1 && volts < threshold) this.resetDue = true;
  }

  /** An interrupt that is pending while it is masked ends a WFI and enters no handler. */
  fixCore() {
    const { core } = this;
    core.setInterrupt = (number, pending) => {
      if (pending) {
        core.pendingInterrupts |= 1 << number;
        if (!core.PM) core.interruptsUpdated = true;
      } else {
        core.pendingInterrupts &= ~(1 << number);
      }
    };
  }

  /** A slice that is phase-correct counts 0 and its top twice (4.5.2.1, 4.5.2.6); rp2040js counts each once. Its timer counts the period. */
  fixPwm() {
    for (const slice of this.mcu.pwm.channels) {
      const { timer } = slice;
      const centred = () => (slice.csr & kPhaseCorrect) !== 0;
      const write = slice.writeRegister.bind(slice);
      slice.writeRegister = (offset, value) => {
        write(offset, value);
        if (offset === kPwmControl) timer.mode = 0;
      };
      const read = slice.readRegister.bind(slice);
      slice.readRegister = (offset) => {
        if (offset !== kPwmCounter || !centred()) return read(offset);
        const { counter } = timer;
        return counter <= slice.top ? counter : 2 * slice.top + 1 - counter;
      };
      const update = slice.updateDoubleBuffered.bind(slice);
      slice.updateDoubleBuffered = () => {
        const changed = slice.topUpdated;
        update();
        if (changed && centred()) timer.top = 2 * slice.top + 1;
      };
    }
  }

  /** SRAM and the USB packets' buffers without rp2040js's search of the address map, with the same result. */
  shortenAccesses() {
    const { core, mcu } = this;
    const halfwords = new Uint16Array(mcu.sram.buffer, mcu.sram.byteOffset, mcu.sram.length / 2);
    const words = new Uint32Array(mcu.sram.buffer, mcu.sram.byteOffset, mcu.sram.length / 4);
    const inSram = (address) => address >>> 0 >= kSram && address >>> 0 < kSram + mcu.sram.length;
    core.readUint16 = (address) => (inSram(address) ? halfwords[((address >>> 0) - kSram) >>> 1] : mcu.readUint16(address));
    core.readUint32 = (address) => (inSram(address) && (address & 3) === 0 ? words[((address >>> 0) - kSram) >>> 2] : mcu.readUint32(address));
    core.writeUint8 = (address, value) => {
      const offset = (address >>> 0) - kUsbMemory;
      if (offset >= kUsbBuffers && offset < mcu.usbDPRAM.length) mcu.usbDPRAM[offset] = value;
      else mcu.writeUint8(address, value);
    };
  }

  /** Notes each reading of the converter's status that finds nothing received. */
  watchPolling() {
    const spi = this.mcu.spi[0];
    const read = spi.readUint32.bind(spi);
    this.polling = false;
    this.polled = { registers: new Uint32Array(16), flags: 0, cycles: -kMaxPollingCycles };
    spi.readUint32 = (offset) => {
      const value = read(offset);
      if (offset === kSpiStatus && (value & kSpiReceived) === 0) this.polling = true;
      return value;
    };
  }

  /** The program waits for the converter: passes of its loop that begin with equal registers, a few cycles apart, are equal up to the next
   *  event. They are accounted for at once. */
  skipPolling(end) {
    this.polling = false;
    // Received during the reading itself.
    if (!this.mcu.spi[0].rxFIFO.empty) return;
    const { core, clock, polled } = this;
    const flags = (core.N ? 8 : 0) | (core.Z ? 4 : 0) | (core.C ? 2 : 0) | (core.V ? 1 : 0);
    const cycles = core.cycles - polled.cycles;
    if (cycles <= kMaxPollingCycles && flags === polled.flags && core.registers.every((value, k) => value === polled.registers[k])) {
      const next = Math.min(clock.nextAlarm ? clock.nextAlarm.nanos : end, end);
      const passes = Math.floor((next - clock.nanosCounter - 1) / (cycles * kNanosPerCycle));
      if (passes > 0) {
        clock.nanosCounter += passes * cycles * kNanosPerCycle;
        core.cycles += passes * cycles;
        this.busyCycles += passes * cycles;
      }
    }
    polled.flags = flags;
    polled.cycles = core.cycles;
    polled.registers.set(core.registers);
  }

  /** Runs until the absolute time `us`, or until `stop()` is true after a step. */
  runUntil(us, stop) {
    for (;;) {
      const { core, clock, visited } = this;
      const end = us * 1000 - this.baseNanos;
      while (clock.nanosCounter < end && !this.resetDue) {
        if (core.waiting) {
          if (core.pendingInterrupts & core.enabledInterrupts) {
            core.waiting = false;
            continue;
          }
          const next = clock.nextAlarm;
          clock.tick(Math.min(next ? next.nanos : end, end) - clock.nanosCounter);
        } else {
          const pc = core.registers[15];
          if (pc < kRomEnd) {
            this.runRom(pc | 1);
            continue;
          }
          if (pc >= 0x20000000) visited[(pc - 0x20000000) >> 1] = 1;
          else this.visitedInFlash[(pc - 0x10000000) >> 1] = 1;
          const cycles = core.executeInstruction();
          this.busyCycles += cycles;
          clock.tick(cycles * kNanosPerCycle);
          if (this.polling) this.skipPolling(end);
        }
        if (stop && stop()) return this.checked(true);
      }
      if (!this.resetDue) return this.checked(false);
      this.baseNanos += clock.nanosCounter;
      this.resetUs = this.baseNanos / 1000;
      if (!this.supplyChanged) ++this.resets;
      this.supplyChanged = false;
      this.boot();
    }
  }

  run(us, stop) { return this.runUntil(this.us + us, stop); }

  /** Limits of the emulator and errors of the firmware are both errors here. */
  checked(result) {
    if (this.warnings.length > 0) throw new Error(`emulator: ${[...new Set(this.warnings)].join('; ')}`);
    return result;
  }

  /** Simulates a program stuck in an endless loop. */
  hang() {
    this.mcu.sram.set(kHang, 0);
    this.core.PC = 0x20000000;
    this.core.waiting = false;
  }

  /** The supply of the processor goes, or comes again. */
  setPowered(powered) {
    this.powered = powered;
    this.supplyChanged = true;
    this.resetDue = true;
  }

  /** A processor in lock-up executes nothing (ARMv6-M Architecture Reference Manual B1.5.15): a fault within a fault, or one whose stack
   *  frame cannot be written. */
  lockUp() { sleepForGood(this.core); }

  /** Enters a HardFault as the processor does and rp2040js never does. */
  fault() {
    this.core.PC = this.mcu.readUint32(this.core.VTOR + 4 * 3) & ~1;
    this.core.waiting = false;
  }

  /** Addresses of the executed instructions; the second stage's at its link address. */
  executed() {
    const of = (array, base) => [...array.keys()].filter((i) => array[i]).map((i) => base + 2 * i);
    const sram = of(this.visited, 0x20000000).map((pc) => (pc >= kBoot2At ? pc - kBoot2At + 0x10000000 : pc));
    return [...of(this.visitedInFlash, 0x10000000), ...sram];
  }

  stackUsed() {
    // The first bytes are the loop of `hang`.
    const free = this.mcu.sram.subarray(2, kStackBytes).findIndex((byte) => byte !== kPaint);
    return kStackBytes - 2 - free;
  }
}
