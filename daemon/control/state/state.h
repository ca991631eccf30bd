// SPDX-License-Identifier: MIT
// The states of the ball and the named reasons for them (protocol/README.md,
// daemon/control/trip-reasons.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hedgehog::control {

enum class State : std::uint8_t { kAbsent, kDisarmed, kArmed, kTripped };

/// Reason of the present state. The wire names are the enumerators in snake_case without the k
/// (`sensor_frozen`).
enum class Reason : std::uint8_t {
  kNone,
  // disarmed
  kNeverArmed,     // arm_at_start is never, or first start of a real board
  kUncleanStop,    // the last run did not end by SIGTERM, or ended with a latch
  kHotPlug,        // the board was connected again
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
  kUnexpectedCurrent,  // a coil carries current without a request, or more than is measured
  kCurrentMismatch,    // the measured current differs from that expected by L/R
  kBridgeFault,
  kFanStopped,
  kBoardDeadMan,
  kBoardOverCurrent,
  kBoardOverHeat,
  kBoardHeatBudget,
  kBoardStuckBridge,
  kBoardSupply,
  kThermometerLost,       // no reading of the second thermometer for 5 s
  kThermometerDisagrees,  // more than 10 K from the coil sensor for 5 s
  kShellHot,              // the skin side is at 48 C
  kTelemetryLost,         // no valid board telemetry for 100 ms
  kStateLost,             // the saved state is damaged or of another ball: a latch may be lost
  kMeasurementsDisagree,  // contradicting measurements, one of which protects against overheating
  kInternal,              // repeatedly a non-finite number
  // absent
  kBootLoader,  // device.enter_boot_loader: the board waits for new firmware
};

inline constexpr std::size_t kReasonCount = static_cast<std::size_t>(Reason::kBootLoader) + 1;

std::string_view name(State state) noexcept;
std::string_view name(Reason reason) noexcept;
/// kNone if `text` is not the name of a reason.
Reason reason_named(std::string_view text) noexcept;

}  // namespace hedgehog::control
