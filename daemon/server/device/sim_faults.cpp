// SPDX-License-Identifier: MIT
#include "daemon/server/device/sim_faults.h"

#include <array>
#include <utility>

#include "daemon/device/simulator/simulator_settings.h"

namespace hedgehog::server {
namespace {

using FaultName = std::pair<std::string_view, device::SimFault>;
constexpr std::array<FaultName, 13> kFaults{{
    {"sensor_open", device::kSimSensorOpen},
    {"sensor_short", device::kSimSensorShort},
    {"sensor_frozen", device::kSimSensorFrozen},
    {"sensor_jump", device::kSimSensorJump},
    {"sensor_stale", device::kSimSensorStale},
    {"sensor_offset", device::kSimSensorOffset},
    {"stuck_bridge", device::kSimStuckBridge},
    {"bridge_fault", device::kSimBridgeFault},
    {"open_winding", device::kSimOpenWinding},
    {"fan_stopped", device::kSimFanStopped},
    {"silent", device::kSimSilent},
    {"current_sense", device::kSimCurrentSense},
    {"supply_low", device::kSimSupplyLow},
}};

}  // namespace

std::optional<std::uint16_t> sim_fault_named(std::string_view name) noexcept {
  for (const auto& [text, bit] : kFaults)
    if (text == name) return bit;
  return std::nullopt;
}

std::vector<std::string> sim_fault_names(std::uint16_t bits) {
  std::vector<std::string> names;
  for (const auto& [text, bit] : kFaults)
    if ((bits & bit) != 0) names.emplace_back(text);
  return names;
}

}  // namespace hedgehog::server
