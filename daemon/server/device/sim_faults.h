// SPDX-License-Identifier: MIT
// Wire names of the faults of the simulated board (`sim.set`).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::server {

/// A bit of device::SimFault; nullopt: no such fault.
std::optional<std::uint16_t> sim_fault_named(std::string_view name) noexcept;
/// Every name of `bits`, in the order of device::SimFault.
std::vector<std::string> sim_fault_names(std::uint16_t bits);

}  // namespace hedgehog::server
