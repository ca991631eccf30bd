// SPDX-License-Identifier: MIT
// Trace of a simulated board: one JSON line at the start, at every change of mode, when the current
// has decayed after driving, and at events of its runner:
//   {"event","board_ms","set_point_age_ms","mode","faults","awake","duty","current_a"}
// in the board's own milliseconds; set_point_age_ms is null before the first set-point, duty the
// largest of the three, current_a the true Euclidean norm.
#pragma once

#include <cstdio>
#include <string>

#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

const char* words(board::Mode mode) noexcept;  // "latched"

/// The board's thread.
class SimulatedBoardTrace {
 public:
  static constexpr double kZeroA = 0.1;  // below it the windings count as without current

  explicit SimulatedBoardTrace(std::FILE* file) noexcept : file_(file) {}  // null: no trace

  void after_step(const SimulatedBoard& board) noexcept;
  void note(const SimulatedBoard& board, const char* event) noexcept;

 private:
  std::FILE* file_;
  board::Mode mode_ = board::Mode::kSafe;
  bool current_flowed_ = false;
};

}  // namespace hedgehog::device
