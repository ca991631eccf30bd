// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulated_board_trace.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace hedgehog::device {

const char* words(board::Mode mode) noexcept {
  switch (mode) {
    case board::Mode::kSafe:
      return "safe";
    case board::Mode::kReady:
      return "ready";
    case board::Mode::kDriving:
      return "driving";
    case board::Mode::kLatched:
      return "latched";
  }
  return "latched";
}

void SimulatedBoardTrace::after_step(const SimulatedBoard& board) noexcept {
  if (board.core().mode() != mode_) {
    mode_ = board.core().mode();
    note(board, "mode");
  }
  const bool flows = norm(board.plant().current_a()) >= kZeroA;
  if (current_flowed_ && !flows && !board.core().outputs().awake) note(board, "zero");
  current_flowed_ = flows;
}

void SimulatedBoardTrace::note(const SimulatedBoard& board, const char* event) noexcept {
  if (file_ == nullptr) return;
  const board::BoardCore& core = board.core();
  const std::uint32_t age_ms = core.set_point_age_ms();
  const std::string age = age_ms == UINT32_MAX ? "null" : std::to_string(age_ms);
  int duty = 0;
  for (const std::int16_t one : core.outputs().duty_q15) duty = std::max(duty, std::abs(one));
  std::fprintf(file_,
               "{\"event\": \"%s\", \"board_ms\": %u, \"set_point_age_ms\": %s, \"mode\": \"%s\", "
               "\"faults\": %u, \"awake\": %s, \"duty\": %.4f, \"current_a\": %.4f}\n",
               event, core.now_ms(), age.c_str(), words(core.mode()),
               static_cast<unsigned>(core.faults()), core.outputs().awake ? "true" : "false",
               duty / kFullDuty, norm(board.plant().current_a()));
  std::fflush(file_);
}

}  // namespace hedgehog::device
