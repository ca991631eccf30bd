// SPDX-License-Identifier: MIT
// Transport of frames to the board and back. USB and the simulated board's socket implement it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {

/// Packets read per tick: more than a socket buffers during a pause, so that no old telemetry
/// remains, and a bound on the run time under a flood.
inline constexpr int kMaxPacketsPerTick = 512;

/// Owned and used by the link thread only. Never waits.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// False: not sent (full, or no board). The frame is dropped; the next millisecond has another.
  virtual bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept = 0;

  /// Length of the next received packet; 0: none. Longer ones are truncated to the buffer, so pass
  /// one larger than a frame to detect them.
  virtual std::size_t receive(std::span<std::uint8_t> packet) noexcept = 0;

  virtual bool open() const noexcept = 0;  // false: the other end has closed permanently

  virtual bool idle() const noexcept { return false; }  // no peer, but one may connect
};

}  // namespace hedgehog::device
