// SPDX-License-Identifier: MIT
// The third serial port of a PC (16550A at 0x3E8), by its registers and without interrupts: for an
// emulated machine whose clock counts instructions. There a read of a register takes one
// instruction, in whatever time the process at the other end needs, whereas a thread that waits for
// a file lets the clock advance to the next timer.
#pragma once

#include "emulator/firmware/byte_port.h"

namespace hedgehog::emulator {

/// Needs root, and a processor with I/O ports (x86).
class Uart final : public BytePort {
 public:
  /// Discards what has been received. Throws std::runtime_error, std::system_error.
  Uart();
  void write(std::span<const device::Byte> bytes) override;
  std::optional<device::Byte> poll() override;
};

}  // namespace hedgehog::emulator
