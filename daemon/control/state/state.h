// SPDX-License-Identifier: MIT
// The states of the ball and the named reasons for them (protocol/README.md,
// daemon/control/trip-reasons.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hedgehog::control {

enum class State : std::uint8_t { kAbsent, kDisarmed, kArmed, kTripped };

/// Why the state is what it is. The wire names are the enumerators in snake_case without the k
/// (`sensor_frozen`).
enum class Reason : std::uint8_t {
  kNone,
  // disarmed
  kNeverArmed,     // arm_at_start says never, or the first start of a real board
  kUncleanStop,    // the last run did not end by SIGTERM without a latch
  kHotPlug,        // the board came back
  kEmergencyStop,  // device.emergency_stop; latched over restarts
  // absent
  kNoBoard,
  // tripped
  kOverheated,  // 70 C held for 50 ms
  kSensorOpen,
  kSensorShort,
  kSensorFrozen,
  kSensorJump,
  kSensorStale,
  kSensorImplausible,  // outside -20..125 C
  kSensorDisagrees,    // more than 12 K from the lagged estimate of its own winding for 0.5 s
  kUnexpectedCurrent,  // a coil is driven though nothing was asked
  kCurrentMismatch,    // measured current is not what L/R lets one expect
  kBridgeFault,
  kFanStopped,
  kBoardDeadMan,
  kBoardOverCurrent,
  kBoardOverHeat,
  kBoardHeatBudget,
  kBoardStuckBridge,
  kBoardSupply,
  kThermometerLost,       // the second thermometer says nothing for 5 s
  kThermometerDisagrees,  // it is more than 10 K from the coil sensor for 5 s
  kShellHot,              // the skin side is at 48 C
  kTelemetryLost,         // no valid board telemetry for 100 ms
  kStateLost,             // the saved state is damaged or of another ball: a latch may be forgotten
  kMeasurementsDisagree,  // two of them contradict each other, and one of them guards the heat
  kInternal,              // a number that cannot be, again and again
  // absent
  kBootLoader,  // device.enter_boot_loader: the board waits for new firmware
};

inline constexpr std::size_t kReasonCount = static_cast<std::size_t>(Reason::kBootLoader) + 1;

std::string_view name(State state) noexcept;
std::string_view name(Reason reason) noexcept;
/// kNone when `text` names no reason.
Reason reason_named(std::string_view text) noexcept;

}  // namespace hedgehog::control
