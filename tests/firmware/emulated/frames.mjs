// SPDX-License-Identifier: MIT
// The frames of daemon/device/board-protocol.md, from the host's side.

const kTable = Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n >>> 0;
});

export function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kTable[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

function frame(type, flags, sequence, fill) {
  const bytes = Buffer.alloc(64);
  bytes.set([0x48, 1, type, flags]);
  bytes.writeUInt32LE(sequence >>> 0, 4);
  fill(bytes);
  bytes.writeUInt32LE(crc32(bytes.subarray(0, 60)), 60);
  return bytes;
}

/** Duties -1..1 of the supply. */
export function setPoint(sequence, { enable = true, duty = [0, 0, 0], boost = [0, 0, 0], fan = 0 } = {}) {
  return frame(0x01, enable ? 1 : 0, sequence, (bytes) => {
    duty.forEach((one, k) => bytes.writeInt16LE(Math.round(one * 32767), 8 + 2 * k));
    bytes[14] = fan;
    boost.forEach((one, k) => bytes.writeInt16LE(Math.round(one * 32767), 16 + 2 * k));
  });
}

export const arm = (sequence, count) => frame(0x02, 0, sequence, (bytes) => void (bytes[8] = count));

/** Hundredths of a degree, mA, thousandths of the heat budgets. */
export const limits = (sequence, { sensorCc = 7500, currentMa = 16500, heat = 1000 }) => frame(0x03, 0, sequence, (bytes) => {
  bytes.writeInt16LE(sensorCc, 8);
  bytes.writeUInt16LE(currentMa, 10);
  bytes.writeUInt16LE(heat, 12);
});

/** The key is "BOOT". */
export const bootLoader = (sequence, key = 0x544f4f42) => frame(0x04, 0, sequence, (bytes) => void bytes.writeUInt32LE(key, 8));

/** The compare value of a duty (board_core/port.cpp, firmware/pico_wiring.h). */
export const compareValue = (dutyQ15) => Math.floor((3124 * Math.abs(dutyQ15)) / 32767);

export const kMode = { safe: 0, ready: 1, driving: 2, latched: 3 };

/** Bits of Fault (daemon/device/board_core/fault.h). */
export const kFault = {
  deadMan: 1 << 0, overCurrent: 1 << 1, overHeat: 1 << 2, heatBudget: 1 << 3, bridge: 1 << 4, sensorOpen: 1 << 5,
  sensorShort: 1 << 6, stuckBridge: 1 << 7, supply: 1 << 8, unexpectedCurrent: 1 << 9, currentSense: 1 << 10,
};

/** Throws on a frame that the host would reject. */
export function telemetry(bytes) {
  const frame = Buffer.from(bytes);
  if (frame.length !== 64 || frame[0] !== 0x48 || frame[1] !== 1 || frame[2] !== 0x81) throw new Error('no telemetry');
  if (crc32(frame.subarray(0, 60)) !== frame.readUInt32LE(60)) throw new Error('telemetry with a wrong check sum');
  return {
    sequence: frame.readUInt32LE(4), received: frame.readUInt32LE(8), setPoint: frame.readUInt32LE(12),
    boardMs: frame.readUInt32LE(16), awake: (frame[3] & 2) !== 0, switchClosed: (frame[3] & 1) !== 0,
    currentMa: [20, 22, 24].map((at) => frame.readInt16LE(at)),
    duty: [26, 28, 30].map((at) => frame.readInt16LE(at) / 32767),
    supplyMv: frame.readUInt16LE(32), sensorC: frame.readInt16LE(34) / 100, fanRpm: frame.readUInt16LE(36),
    mode: frame[39], armCount: frame[40], conversions: frame[41], faults: frame.readUInt16LE(42),
    thermistors: (frame[45] >> 3) & 3, refused: frame.readUInt16LE(54),
  };
}
