// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulator_error.h"

namespace hedgehog::device {
namespace {

struct NamedKind {
  std::string_view name;
  SimulatorErrorRange range;
};
// In the order of SimulatorErrorKind.
constexpr std::array<NamedKind, kSimulatorErrorKinds> kErrorKinds{{
    {"current_gain", {0.0, 3.0, 1.0, true}},
    {"current_offset_a", {-20.0, 20.0, 0.0, true}},
    {"supply_gain", {0.0, 3.0, 1.0, false}},
    {"resistance_gain", {0.1, 10.0, 1.0, true}},
    {"shorted_turns", {0.0, 0.9, 0.0, true}},
    {"pwm_stuck", {-1.0, 1.0, 0.0, true}},
    {"thermistor_offset_k", {-100.0, 100.0, 0.0, true}},
    {"thermistor_contact", {0.0, 1.0, 0.0, true}},
    {"cooling_gain", {0.0, 10.0, 1.0, false}},
    {"heat_capacity_gain", {0.1, 10.0, 1.0, false}},
    {"tach_gain", {0.0, 10.0, 1.0, false}},
}};

const NamedKind& named(SimulatorErrorKind kind) noexcept {
  return kErrorKinds[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string_view name(SimulatorErrorKind kind) noexcept { return named(kind).name; }

SimulatorErrorRange range_of(SimulatorErrorKind kind) noexcept { return named(kind).range; }

std::optional<SimulatorErrorKind> simulator_error_kind(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kErrorKinds.size(); ++i)
    if (kErrorKinds[i].name == name) return static_cast<SimulatorErrorKind>(i);
  return std::nullopt;
}

}  // namespace hedgehog::device
