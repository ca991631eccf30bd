// SPDX-License-Identifier: MIT
// A full-speed host in place of rp2040js's, which completes transfers of unread packets and hides STALL, toggles, SOF and suspend: tokens
// are checked against the buffers that the firmware has armed.

const kAvailable = 1 << 10;
const kStall = 1 << 11;
const kData1 = 1 << 13;
const kFull = 1 << 15;
const kEnabled = 1 << 31;
const kPullUp = 1 << 16;
const kSuspended = 1 << 4;
const kBusReset = 1 << 19;
const kSofEvent = 1 << 17;
const kVbusPin = 24;

// Crystals of host and board differ: the frames drift relative to the board's milliseconds.
const kFrameUs = 1000.3;
const kRetryUs = 20;
const kQuietUs = 900; // no transaction starts later in a frame
const kArmCycles = 12;

function must(what, result) {
  if (typeof result === 'string') throw new Error(`${what}: ${result}`);
  return result;
}

export class UsbHost {
  constructor() {
    this.plugged = true;
    this.frames = true; // SOFs are sent
    this.reading = true; // the IN endpoint is polled
    this.frameNanos = kFrameUs * 1000;
    this.outQueue = [];
    this.received = [];
    this.onFrame = () => {};
    this.onIn = () => {};
    this.onOut = () => {};
    this.onStall = () => {}; // called with the address of a bulk endpoint
    this.onReceived = () => {}; // called when a bulk packet has been read from the controller's memory
    this.busyHub = false;
    this.unresponsive = false;
    this.counts = { sof: 0, nak: 0, stall: 0, toggle: 0, late: 0, unarmed: 0 };
    this.resetBus();
  }

  resetBus() {
    this.address = 0;
    this.toggle = new Map();
    this.configured = false;
  }

  attach(mcu, chip) {
    this.chip = chip;
    this.mcu = mcu;
    this.resetBus();
    this.phy = new Map();
    this.idleUs = undefined;
    this.frameUs = -1e9;
    this.suspended = false;
    const usb = (this.usb = mcu.usbCtrl);
    mcu.gpio[kVbusPin].setInputValue(this.plugged);
    this.watchArming();
    const read = usb.readUint32.bind(usb);
    usb.readUint32 = (offset) => {
      if (offset === 0x48) this.event(kSofEvent, false);
      return read(offset);
    };
    const write = usb.writeUint32.bind(usb);
    usb.writeUint32 = (offset, value) => {
      if (offset === 0x78) return; // power: not modelled
      if (offset === 0x74) this.route(value);
      if (offset === 0x7c || offset === 0x80) this.phy.set(offset, value);
      if (offset === 0x74 || offset === 0x7c || offset === 0x80) return;
      if (offset === 0x50 && usb.rawWriteValue & kSuspended) usb.sieStatus &= ~kSuspended;
      write(offset, value);
    };
    const every = (nanos, what) => {
      const alarm = mcu.clock.createAlarm(() => {
        alarm.schedule(nanos());
        what();
      });
      alarm.schedule(nanos());
    };
    every(() => this.frameNanos, () => this.frame());
    every(() => kRetryUs * 1000, () => this.bulk());
  }

  /** A chip before B2 behind a busy hub responds after a reset only once it has seen an idle line (erratum E5). */
  route(muxing) {
    const pin = this.mcu.gpio[15];
    const pullUp = this.phy.get(0x7c) === 1 << 1 && this.phy.get(0x80) === 1 << 2;
    const idle = muxing === 12 && pin.functionSelect === 8 && pin.inputOverride === 3 && pin.outputEnableOverride === 2 && pullUp;
    if (idle) this.idleUs = this.chip.us;
    else if (muxing === 9 && this.idleUs !== undefined) {
      if (this.chip.us - this.idleUs >= 800) this.unresponsive = false;
      this.idleUs = undefined;
    }
  }

  /** The data sheet's rule for AVAILABLE, and erratum E15 for packets sent. */
  watchArming() {
    const last = new Map();
    this.usb.DPRAMUpdated = (offset, value) => {
      if (offset < 0x80 || offset > 0x8c) return;
      const cycles = this.mcu.core.cycles;
      const before = last.get(offset);
      last.set(offset, { value, cycles });
      if (!(value & kAvailable)) return;
      if (before?.value !== (value & ~kAvailable) || cycles - before.cycles < kArmCycles) ++this.counts.unarmed;
      const into = this.chip.us - this.frameUs;
      if (offset === 0x8c && this.unread !== undefined) {
        this.onReceived(this.unread);
        this.unread = undefined;
      }
      if (offset === 0x88 && into >= 800 && into < 998) ++this.counts.late;
    };
  }

  event(bit, set) {
    if (set) this.usb.intRaw |= bit;
    else this.usb.intRaw &= ~bit;
    this.usb.checkInterrupts();
  }

  get connected() { return this.plugged && (this.usb.sieCtrl & kPullUp) !== 0 && (this.usb.mainCtrl & 1) !== 0; }

  frame() {
    if (!this.connected) return;
    const now = this.chip.us;
    if (this.frames) {
      this.suspended = false;
      this.frameUs = now;
      ++this.counts.sof;
      this.usb.sofFrameNumber = (this.usb.sofFrameNumber + 1) & 0x7ff;
      this.event(kSofEvent, true);
      if (this.configured) this.onFrame(this);
    } else if (!this.suspended && now - this.frameUs > 3000) {
      this.suspended = true;
      this.usb.sieStatus |= kSuspended;
      this.usb.sieStatusUpdated();
    }
  }

  bulk() {
    if (!this.configured || !this.frames || !this.connected || this.chip.us - this.frameUs > kQuietUs) return;
    if (this.outQueue.length > 0) {
      const result = this.out(1, this.outQueue[0]);
      if (result === 'stall') this.onStall(0x01);
      if (result !== 'nak') this.onOut(this.outQueue.shift(), this.chip.us);
    }
    if (!this.reading) return;
    const packet = this.in(1);
    if (packet === 'stall') this.onStall(0x81);
    if (typeof packet === 'string') return;
    this.received.push({ us: this.chip.us, packet });
    this.onIn(packet, this.chip.us);
  }

  listens() {
    return this.connected && !this.unresponsive && (this.usb.addrEndp & 0x7f) === this.address && !(this.usb.sieStatus & kBusReset);
  }

  enabled(endpoint, out) {
    if (endpoint === 0) return true;
    return (this.mcu.usbDPRAMView.getUint32(8 * endpoint + (out ? 4 : 0), true) & kEnabled) !== 0;
  }

  /** Whether a packet of the device waits in the buffer of this endpoint. */
  armed(endpoint) { return (this.bufferControl(endpoint, false).control & kAvailable) !== 0; }

  bufferControl(endpoint, out) {
    const at = 0x80 + 8 * endpoint + (out ? 4 : 0);
    return { at, control: this.mcu.usbDPRAMView.getUint32(at, true) };
  }

  /** The response to a token: 'none', 'stall', 'nak', or the armed buffer control. */
  token(endpoint, out) {
    if (!this.listens() || !this.enabled(endpoint, out)) return 'none';
    const { at, control } = this.bufferControl(endpoint, out);
    if (control & kStall && (endpoint > 0 || this.usb.epStallArm & (out ? 2 : 1))) {
      ++this.counts.stall;
      return 'stall';
    }
    if (!(control & kAvailable) || out === ((control & kFull) !== 0)) {
      ++this.counts.nak;
      return 'nak';
    }
    const key = endpoint | (out ? 0 : 0x80);
    const expected = this.toggle.get(key) ?? 0;
    if (expected !== (control & kData1 ? 1 : 0)) {
      ++this.counts.toggle;
      return 'toggle';
    }
    this.toggle.set(key, expected ^ 1);
    return { at, control };
  }

  in(endpoint) {
    const buffer = this.token(endpoint, false);
    if (typeof buffer === 'string') return buffer;
    const offset = this.usb.getEndpointBufferOffset(endpoint, false);
    const data = this.mcu.usbDPRAM.slice(offset, offset + (buffer.control & 0x3ff));
    this.mcu.usbDPRAMView.setUint32(buffer.at, buffer.control & ~(kAvailable | kFull), true);
    this.usb.indicateBufferReady(endpoint, false);
    return data;
  }

  out(endpoint, data) {
    const buffer = this.token(endpoint, true);
    if (typeof buffer === 'string') return buffer;
    const length = Math.min(data.length, buffer.control & 0x3ff);
    this.mcu.usbDPRAM.set(data.subarray(0, length), this.usb.getEndpointBufferOffset(endpoint, true));
    this.mcu.usbDPRAMView.setUint32(buffer.at, (buffer.control & ~(kAvailable | 0x3ff)) | kFull | length, true);
    if (endpoint > 0) this.unread = data;
    this.usb.indicateBufferReady(endpoint, true);
    return 'ack';
  }

  retry(transaction) {
    for (let tries = 0; tries < 500; ++tries) {
      this.chip.run(kRetryUs);
      const result = transaction();
      if (result !== 'nak') return result;
    }
    return 'timeout';
  }

  /** A control transfer; returns the data read, 'stall', or the error. `sent`: the data of an OUT request. */
  control(type, request, value = 0, index = 0, length = 0, sent = new Uint8Array(0)) {
    if (!this.listens()) return 'none';
    this.usb.epStallArm = 0;
    for (const at of [0x80, 0x84])
      this.mcu.usbDPRAMView.setUint32(at, this.mcu.usbDPRAMView.getUint32(at, true) & ~(kAvailable | kStall), true);
    this.toggle.set(0x80, 1).set(0, 1);
    this.usb.sendSetupPacket(Uint8Array.of(type, request, value, value >> 8, index, index >> 8, length, length >> 8));
    const data = [];
    if (type & 0x80 && length > 0) {
      for (;;) {
        const part = this.retry(() => this.in(0));
        if (typeof part === 'string') return part;
        data.push(...part);
        if (part.length < 64 || data.length >= length) break;
      }
      this.toggle.set(0, 1);
      const status = this.retry(() => this.out(0, new Uint8Array(0)));
      return status === 'ack' ? Uint8Array.from(data) : status;
    }
    for (let at = 0; at < sent.length; at += 64) {
      const part = this.retry(() => this.out(0, sent.subarray(at, at + 64)));
      if (part !== 'ack') return part;
    }
    const status = this.retry(() => this.in(0));
    return typeof status === 'string' ? status : Uint8Array.of();
  }

  reset() {
    this.resetBus();
    this.chip.run(10000);
    this.unresponsive = this.busyHub && this.chip.revision < 2;
    this.usb.sieStatus |= kBusReset;
    this.usb.sieStatusUpdated();
    this.chip.run(10000);
  }

  descriptor(type, index = 0, length = 255) { return this.control(0x80, 6, (type << 8) | index, type === 3 && index > 0 ? 0x409 : 0, length); }

  /** Resets the bus and gives the device its address; throws when it does not respond correctly. Returns its descriptor. */
  connect(address = 7) {
    if (!this.chip.run(200000, () => this.connected)) throw new Error('no device pulls up');
    this.reset();
    const device = must('device descriptor', this.descriptor(1, 0, 18));
    must('address', this.control(0, 5, address));
    this.chip.run(2000);
    this.address = address;
    return device;
  }

  /** Enumerates as an operating system does; throws when the device does not respond correctly. */
  enumerate(address = 7) {
    const device = this.connect(address);
    const configuration = must('configuration descriptor', this.descriptor(2));
    const strings = [1, 2, 3].map((index) => Buffer.from(must('string', this.descriptor(3, index))).toString('utf16le', 2));
    this.configure();
    return { device, configuration, strings };
  }

  /** A control transfer of the operating system; what it changes at both ends of the bus is changed in this host too. */
  request(type, request, value, index, length, sent) {
    const result = this.control(type, request, value, index, length, sent);
    if (typeof result === 'string') return result;
    const restarts = (type === 0 && request === 9) || (type === 1 && request === 11);
    if (restarts) this.toggle.set(1, 0).set(0x81, 0);
    if (type === 0 && request === 9) this.configured = value !== 0;
    if (type === 2 && request === 1 && value === 0) this.toggle.set(index, 0);
    return result;
  }

  configure() { must('configuration', this.request(0, 9, 1, 0, 0)); }

  clearHalt(endpoint) { return this.request(2, 1, 0, endpoint, 0); }

  plug(plugged) {
    this.plugged = plugged;
    this.resetBus();
    this.mcu.gpio[kVbusPin].setInputValue(plugged);
  }
}
