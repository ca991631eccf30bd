// SPDX-License-Identifier: MIT
// Bytes to and from the process of an emulated board.
#pragma once

#include <optional>
#include <span>

#include "daemon/device/byte_order.h"

namespace hedgehog::emulator {

/// The emulator's thread.
class BytePort {
 public:
  virtual ~BytePort() = default;
  /// Throws std::runtime_error when the bytes are not accepted.
  virtual void write(std::span<const device::Byte> bytes) = 0;
  /// The next byte, without waiting; nullopt: none has arrived.
  virtual std::optional<device::Byte> poll() = 0;
};

}  // namespace hedgehog::emulator
