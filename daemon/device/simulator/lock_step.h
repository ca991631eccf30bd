// SPDX-License-Identifier: MIT
// Link and simulated board as one pure step, without threads, and with a clock for time stamps
// only: for the test rig, and for `hedgehogd --simulate --speed N`, where the control thread drives
// it.
#pragma once

#include <optional>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

/// Link and board in steps of a millisecond. One thread.
class SteppedBoard {
 public:
  SteppedBoard() = default;
  SteppedBoard(const SteppedBoard&) = delete;
  SteppedBoard& operator=(const SteppedBoard&) = delete;
  virtual ~SteppedBoard() = default;

  /// Advances both by one millisecond. Applies what was written to the port before.
  virtual void step() noexcept = 0;
};

/// One thread. Telemetry takes one step from the board to the port, a command none: one that is
/// written to the port before `step` is applied in it.
class LockStep final : public SteppedBoard {
 public:
  explicit LockStep(LinkPort& port, const SimulatedBoardOptions& options = {},
                    const std::optional<BoardLimits>& limits = std::nullopt) noexcept
      : port_(port), link_(limits ? Link(*limits) : Link()), board_(options) {}

  void step() noexcept override;

  SimulatedBoard& board() noexcept { return board_; }
  const Link& link() const noexcept { return link_; }

 private:
  LinkPort& port_;
  Link link_;
  SimulatedBoard board_;
};

}  // namespace hedgehog::device
