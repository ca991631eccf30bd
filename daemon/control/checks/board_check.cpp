// SPDX-License-Identifier: MIT
#include "daemon/control/checks/board_check.h"

#include <algorithm>

#include "daemon/device/board_codec.h"

namespace hedgehog::control {

Reason reason_of_faults(std::uint16_t faults) noexcept {
  if ((faults & board::kStuckBridge) != 0) return Reason::kBoardStuckBridge;
  if ((faults & board::kBridge) != 0) return Reason::kBridgeFault;
  if ((faults & board::kUnexpectedCurrent) != 0) return Reason::kUnexpectedCurrent;
  if ((faults & board::kCurrentSense) != 0) return Reason::kCurrentMismatch;
  if ((faults & board::kOverCurrent) != 0) return Reason::kBoardOverCurrent;
  if ((faults & board::kOverHeat) != 0) return Reason::kBoardOverHeat;
  if ((faults & board::kHeatBudget) != 0) return Reason::kBoardHeatBudget;
  if ((faults & board::kSupply) != 0) return Reason::kBoardSupply;
  if ((faults & board::kSensorOpen) != 0) return Reason::kSensorOpen;
  if ((faults & board::kSensorShort) != 0) return Reason::kSensorShort;
  if ((faults & board::kDeadMan) != 0) return Reason::kBoardDeadMan;
  return Reason::kNone;
}

model::Limits limits_within(model::Limits limits, const device::BoardTelemetry& board) noexcept {
  // Rounding of the wire format: whole milliamperes and hundredths of a degree.
  constexpr double kRounding = 0.01;
  const auto wanted = device::BoardLimits::of(limits);
  if (board.limit_current_a < wanted.current_a - kRounding) {
    limits.current_a *= std::max(0.0, board.limit_current_a / wanted.current_a);
    limits.continuous_a = std::min(limits.continuous_a, limits.current_a);
    limits.felt_a = std::min(limits.felt_a, limits.current_a);
  }
  if (board.limit_sensor_c < wanted.sensor_c - kRounding) {
    const double less_k = wanted.sensor_c - board.limit_sensor_c;
    limits.derate_from_c -= less_k;
    limits.sustain_c -= less_k;
    limits.zero_c -= less_k;
    limits.trip_c -= less_k;
  }
  return limits;
}

void BoardCheck::step(bool present, bool fresh, const device::BoardTelemetry& board,
                      model::Tick ticks) noexcept {
  age_ = fresh ? 0 : age_ + ticks;
  alive_ = present && age_ < kSilence;
  if (!fresh) return;
  fault_ = reason_of_faults(board.faults);
  const bool armed =
      board.mode == device::BoardMode::kReady || board.mode == device::BoardMode::kDriving;
  idle_ = armed ? 0 : std::min(idle_ + ticks, kRestart);
}

}  // namespace hedgehog::control
