// SPDX-License-Identifier: MIT
// The simulated board within the host's own thread: a transport whose board is computed on access.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/tick_clock.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

/// Never waits. For a late host the missed milliseconds are computed at once, up to the number that
/// TickClock catches up; the others are skipped. A board that must run without its host is a
/// process (simulated_board_process.h).
class SimulatedBoardTransport final : public Transport {
 public:
  using Clock = std::int64_t (*)() noexcept;  // CLOCK_MONOTONIC or a test's clock, ns

  explicit SimulatedBoardTransport(const SimulatedBoardOptions& options,
                                   Clock now_ns = monotonic_ns) noexcept;

  /// Takes effect in the board's next millisecond.
  bool send(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept override;
  /// Runs the milliseconds that are due, then returns their frames one by one.
  std::size_t receive(std::span<std::uint8_t> packet) noexcept override;
  bool open() const noexcept override { return true; }

  const SimulatedBoard& board() const noexcept { return board_; }  // for tests

 private:
  static constexpr std::int64_t kMaxSteps = TickClock::kCatchUp + 1;
  static constexpr std::size_t kFramesAStep = 2;

  void run_due_steps() noexcept;
  void keep(const std::optional<Frame>& frame) noexcept;

  SimulatedBoard board_;
  Clock now_ns_;
  std::int64_t next_ns_;
  std::array<Frame, kMaxSteps * kFramesAStep> frames_{};
  std::size_t queued_ = 0;
  std::size_t delivered_ = 0;
};

}  // namespace hedgehog::device
