// SPDX-License-Identifier: MIT
// The content of an ELF file that a flash programmer writes.
import { readFileSync } from 'node:fs';

const kFlash = 0x10000000;

/** The contents of the flash from 0x10000000 on. */
export function flashImage(path) {
  const file = readFileSync(path);
  const headers = file.readUInt32LE(28);
  const size = file.readUInt16LE(42);
  const count = file.readUInt16LE(44);
  const parts = [];
  for (let i = 0; i < count; ++i) {
    const at = headers + i * size;
    const [type, offset, , address, length] = [0, 4, 8, 12, 16].map((n) => file.readUInt32LE(at + n));
    if (type === 1 && length > 0 && address >= kFlash) parts.push({ offset, address: address - kFlash, length });
  }
  const image = new Uint8Array(Math.max(...parts.map((part) => part.address + part.length)));
  for (const part of parts) image.set(file.subarray(part.offset, part.offset + part.length), part.address);
  return image;
}

/** CRC-32/MPEG-2, as computed by the boot ROM over the second stage. */
export function crc32Mpeg2(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc & 0x80000000 ? 0x04c11db7 : 0);
  }
  return crc >>> 0;
}
