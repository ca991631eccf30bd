// SPDX-License-Identifier: MIT
// The host's packets between their arrival and the board's millisecond.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace hedgehog::firmware {

/// First in, first out; a full one keeps the endpoint from taking more.
class PacketQueue {
 public:
  static constexpr size_t kPacketBytes = 64;
  static constexpr uint32_t kCapacity = 8;

  bool has_capacity() const noexcept { return written_ - read_ < kCapacity; }
  void clear() noexcept { read_ = written_; }

  /// REQUIRES: has_capacity(). Of a longer packet, which no host sends, the first kPacketBytes.
  void put(const volatile uint8_t* bytes, size_t length, uint32_t arrived_us) noexcept {
    Packet& packet = packets_[written_++ % kCapacity];
    packet.arrived_us = arrived_us;
    packet.length = static_cast<uint8_t>(smaller(length, kPacketBytes + 1));
    const size_t stored = smaller(length, kPacketBytes);
    for (size_t i = 0; i < stored; ++i) packet.bytes[i] = bytes[i];
  }

  /// The length of the oldest packet, kPacketBytes + 1 for each that was longer, of which as much
  /// as fits is copied; 0: none.
  size_t take(uint8_t* bytes, size_t capacity) noexcept {
    if (read_ == written_) return 0;
    const Packet& packet = packets_[read_++ % kCapacity];
    taken_arrived_us_ = packet.arrived_us;
    const size_t copied = smaller(smaller(packet.length, kPacketBytes), capacity);
    for (size_t i = 0; i < copied; ++i) bytes[i] = packet.bytes[i];
    return packet.length;
  }

  /// When the packet that was taken last had arrived.
  uint32_t taken_arrived_us() const noexcept { return taken_arrived_us_; }

 private:
  static constexpr size_t smaller(size_t a, size_t b) noexcept { return a < b ? a : b; }

  struct Packet {
    uint32_t arrived_us = 0;
    uint8_t length = 0;
    uint8_t bytes[kPacketBytes] = {};
  };
  Packet packets_[kCapacity];
  uint32_t written_ = 0;
  uint32_t read_ = 0;
  uint32_t taken_arrived_us_ = 0;
};

}  // namespace hedgehog::firmware
