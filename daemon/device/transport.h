// SPDX-License-Identifier: MIT
// Transport of frames to the board and back. USB and the simulated board's socket implement it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {

/// Maximum number of packets read per tick: more than a socket buffers during a pause, so that no
/// old telemetry remains, and a bound on the run time under a flood.
inline constexpr int kMaxPacketsPerTick = 512;

/// Owned and used by the link thread only. Never waits.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Sends one frame. False: it could not be sent (full, or no board); the frame is dropped, the
  /// next millisecond sends another.
  virtual bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept = 0;

  /// The next received packet: its length, or 0 if there is none. Longer ones are truncated to the
  /// buffer, so pass one larger than a frame to detect them.
  virtual std::size_t receive(std::span<std::uint8_t> packet) noexcept = 0;

  /// False once the other end has closed permanently.
  virtual bool open() const noexcept = 0;

  /// True while no peer is connected, but one may connect.
  virtual bool idle() const noexcept { return false; }
};

}  // namespace hedgehog::device
