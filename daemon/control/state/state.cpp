// SPDX-License-Identifier: MIT
#include "daemon/control/state/state.h"

#include <array>
#include <cstddef>

namespace hedgehog::control {
namespace {

constexpr std::array<std::string_view, 4> kStates{"absent", "disarmed", "armed", "tripped"};

constexpr std::array<std::string_view, 32> kReasons{"none",
                                                    "never_armed",
                                                    "unclean_stop",
                                                    "hot_plug",
                                                    "emergency_stop",
                                                    "no_board",
                                                    "overheated",
                                                    "sensor_open",
                                                    "sensor_short",
                                                    "sensor_frozen",
                                                    "sensor_jump",
                                                    "sensor_stale",
                                                    "sensor_implausible",
                                                    "sensor_disagrees",
                                                    "unexpected_current",
                                                    "current_mismatch",
                                                    "bridge_fault",
                                                    "fan_stopped",
                                                    "board_dead_man",
                                                    "board_over_current",
                                                    "board_over_heat",
                                                    "board_heat_budget",
                                                    "board_stuck_bridge",
                                                    "board_supply",
                                                    "thermometer_lost",
                                                    "thermometer_disagrees",
                                                    "shell_hot",
                                                    "telemetry_lost",
                                                    "state_lost",
                                                    "measurements_disagree",
                                                    "internal",
                                                    "boot_loader"};
static_assert(kReasons.size() == kReasonCount);

}  // namespace

std::string_view name(State state) noexcept { return kStates[static_cast<std::size_t>(state)]; }

std::string_view name(Reason reason) noexcept { return kReasons[static_cast<std::size_t>(reason)]; }

Reason reason_named(std::string_view text) noexcept {
  for (std::size_t i = 0; i < kReasons.size(); ++i)
    if (kReasons[i] == text) return static_cast<Reason>(i);
  return Reason::kNone;
}

}  // namespace hedgehog::control
