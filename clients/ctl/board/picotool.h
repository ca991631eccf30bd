// SPDX-License-Identifier: MIT
// Raspberry Pi's picotool, which accesses an RP2040 in its boot loader over USB.
#pragma once

#include <cstdint>
#include <string>

namespace hedgehog::client {

struct PicotoolEnd {
  enum class Kind : std::uint8_t { kMissing, kFailed, kDone };
  Kind kind = Kind::kMissing;
  /// kFailed: the last line of its output, or why it did not run.
  std::string why{};
};

/// `picotool load -x FILE` from the PATH: writes the file and starts the firmware. Waits for its
/// end.
PicotoolEnd load_by_picotool(const std::string& file);

}  // namespace hedgehog::client
