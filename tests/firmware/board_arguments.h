// SPDX-License-Identifier: MIT
// The options of hedgehog-simboard as the ball of the emulated microcontroller is given them.
#pragma once

#include <optional>
#include <span>

#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

struct BoardArguments {
  SimulatedBoardOptions board;
  /// The inherited socket to the host; -1: none given.
  int fd = -1;
};

/// `words` without the program's name. nullopt: an unknown option, or a value that cannot be.
std::optional<BoardArguments> read_board_arguments(std::span<const char* const> words);

}  // namespace hedgehog::device
