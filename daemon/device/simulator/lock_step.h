// SPDX-License-Identifier: MIT
// Link and simulated board as one pure step, without threads or a clock: for the test rig, and for
// `hedgehogd --simulate --speed N`, where the control thread drives it.
#pragma once

#include <optional>

#include "daemon/device/link.h"
#include "daemon/device/link_port.h"
#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

/// One thread. Telemetry takes one step from the board to the port, a command none: what is written
/// to the port before `step` is applied in it.
class LockStep {
 public:
  explicit LockStep(LinkPort& port, const SimulatedBoardOptions& options = {},
                    const std::optional<BoardLimits>& limits = std::nullopt) noexcept
      : port_(port), link_(limits ? Link(*limits) : Link()), board_(options) {}

  /// One millisecond of both.
  void step() noexcept;

  SimulatedBoard& board() noexcept { return board_; }
  const Link& link() const noexcept { return link_; }

 private:
  LinkPort& port_;
  Link link_;
  SimulatedBoard board_;
};

}  // namespace hedgehog::device
