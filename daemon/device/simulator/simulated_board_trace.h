// SPDX-License-Identifier: MIT
// What a simulated board did, for whoever was not there: one JSON line at the start, at every
// change of mode, when the current has died away after driving, and at whatever its runner adds:
//   {"event","board_ms","set_point_age_ms","mode","faults","awake","duty","current_a"}
// in the board's own milliseconds; set_point_age_ms is null before the first set-point, duty the
// largest of the three, current_a the true Euclidean norm.
#pragma once

#include <cstdio>
#include <string>

#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

/// "latched".
const char* words(board::Mode mode) noexcept;

/// The board's thread.
class SimulatedBoardTrace {
 public:
  /// Below this the windings count as without current.
  static constexpr double kZeroA = 0.1;

  /// Null: nothing is written.
  explicit SimulatedBoardTrace(std::FILE* file) noexcept : file_(file) {}

  /// After each step of the board.
  void after_step(const SimulatedBoard& board) noexcept;
  void note(const SimulatedBoard& board, const char* event) noexcept;

 private:
  std::FILE* file_;
  board::Mode mode_ = board::Mode::kSafe;
  bool current_flowed_ = false;
};

}  // namespace hedgehog::device
