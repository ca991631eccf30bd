// SPDX-License-Identifier: MIT
// Transport of frames to the board and back. USB and the simulated board's socket implement it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {

/// Packets read in one tick at most: more than a socket holds after a pause, so that no old
/// telemetry is left behind, and a bound on the time that a flood takes.
inline constexpr int kMaxPacketsPerTick = 512;

/// Owned and used by the link thread alone. Never waits.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Hands one frame over. False: it could not be taken now (full, or the board is gone); the frame
  /// is dropped, the next millisecond brings another.
  virtual bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept = 0;

  /// The next packet that arrived, as it came: its length, or 0 when there is none. Longer ones are
  /// cut to the buffer, so give it more room than a frame to see that they were.
  virtual std::size_t receive(std::span<std::uint8_t> packet) noexcept = 0;

  /// False once the other end is gone for good.
  virtual bool open() const noexcept = 0;

  /// True while there is nobody at the other end, but somebody may come.
  virtual bool idle() const noexcept { return false; }
};

}  // namespace hedgehog::device
