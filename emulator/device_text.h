// SPDX-License-Identifier: MIT
// Parses a device from one word of a command line: "board,serial=B2,start=40".
#pragma once

#include <memory>
#include <string>

#include "emulator/emulated_device.h"

namespace hedgehog::emulator {

struct MadeDevice {
  /// Null: see `failure`.
  std::unique_ptr<EmulatedDevice> device;
  std::string failure;
  std::string name;
  bool plugged = true;
};

/// Throws std::system_error when a trace cannot be written, std::runtime_error when there is no
/// process of a `firmware-board`.
MadeDevice make_device(const std::string& text);
/// "board, mti, ...".
std::string device_kinds();

}  // namespace hedgehog::emulator
