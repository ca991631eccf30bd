// SPDX-License-Identifier: MIT
// The options of hedgehog-simboard, as arguments of the emulated microcontroller's ball.
#pragma once

#include <optional>
#include <span>

#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

struct BoardArguments {
  SimulatedBoardOptions board;
  /// The inherited socket to the host; -1: no socket.
  int fd = -1;
};

/// `words` without the program's name. nullopt: an unknown option, or a value out of range.
std::optional<BoardArguments> read_board_arguments(std::span<const char* const> words);

}  // namespace hedgehog::device
