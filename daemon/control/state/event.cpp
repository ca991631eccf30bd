// SPDX-License-Identifier: MIT
#include "daemon/control/state/event.h"

#include <array>
#include <cstddef>

namespace hedgehog::control {
namespace {

constexpr std::array<std::string_view, 13> kTypes{
    "effect_started",       "effect_ended",     "state_changed",        "derating_started",
    "derating_ended",       "orientation_lost", "orientation_restored", "measurement_rejected",
    "measurement_accepted", "device_attached",  "device_detached",      "overrun",
    "rejected_number"};
static_assert(kTypes.size() == static_cast<std::size_t>(EventType::kRejectedNumber) + 1);

constexpr std::array<std::string_view, 8> kEndReasons{
    "completed", "stopped",      "replaced", "preempted",
    "expired",   "disconnected", "tripped",  "orientation_lost"};
static_assert(kEndReasons.size() == static_cast<std::size_t>(EndReason::kOrientationLost) + 1);

}  // namespace

std::string_view name(EventType type) noexcept { return kTypes[static_cast<std::size_t>(type)]; }

std::string_view name(EndReason reason) noexcept {
  return kEndReasons[static_cast<std::size_t>(reason)];
}

}  // namespace hedgehog::control
