// SPDX-License-Identifier: MIT
#include "emulator/emulated_device.h"

namespace hedgehog::emulator {

SetupPacket SetupPacket::of(std::span<const Byte, 8> bytes) noexcept {
  return {bytes[0], bytes[1], device::little_u16(&bytes[2]), device::little_u16(&bytes[4]),
          device::little_u16(&bytes[6])};
}

std::optional<std::string> EmulatedDevice::command(std::span<const std::string> /*words*/) {
  return std::nullopt;
}

}  // namespace hedgehog::emulator
