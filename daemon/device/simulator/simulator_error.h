// SPDX-License-Identifier: MIT
// An injected error of measurement or of the ball itself on the simulated board (`sim.set`),
// immediate or as a ramp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hedgehog::device {

/// Wire names: the enumerators in snake_case.
enum class SimulatorErrorKind : std::uint8_t {
  kCurrentGain,        // reading / true
  kCurrentOffsetA,     // reading - true, A
  kSupplyGain,         // reading / true, of the supply's voltage
  kResistanceGain,     // true R25 / built R25
  kShortedTurns,       // share of the turns, 0..0.9
  kPwmStuck,           // duty of the bridge while it is awake, -1..1
  kThermistorOffsetK,  // reading - true, K
  kThermistorContact,  // lost share of its contact, 0..1
  kCoolingGain,        // true / built, core to ambient
  kHeatCapacityGain,   // true / built
  kTachGain,           // reading / true
};
inline constexpr int kSimulatorErrorKinds = 11;

/// "current_gain". nullopt: no such kind.
std::string_view name(SimulatorErrorKind kind) noexcept;
std::optional<SimulatorErrorKind> simulator_error_kind(std::string_view name) noexcept;

/// Range of `value`. Trivially copyable.
struct SimulatorErrorRange {
  double min = 0.0;
  double max = 0.0;
  /// The value without an error.
  double none = 0.0;
  /// Affects one winding, or the thermistor on it.
  bool of_winding = false;
};
SimulatorErrorRange range_of(SimulatorErrorKind kind) noexcept;

struct SimulatorError {
  SimulatorErrorKind kind = SimulatorErrorKind::kCurrentGain;
  /// 0..2; for kinds that affect one winding.
  std::uint8_t coil = 0;
  double value = 1.0;
  /// Duration of the linear ramp in the board's time, s; 0: immediate.
  double ramp_s = 0.0;
  friend constexpr bool operator==(const SimulatorError&, const SimulatorError&) noexcept = default;
};

/// At most one of each kind on each winding has an effect. Trivially copyable.
struct SimulatorErrorList {
  static constexpr std::size_t kMaxErrors = 32;
  /// Changes with each new list: setting the same errors again restarts their ramps.
  std::uint8_t generation = 0;
  std::uint8_t count = 0;
  std::array<SimulatorError, kMaxErrors> error{};
  friend constexpr bool operator==(const SimulatorErrorList&,
                                   const SimulatorErrorList&) noexcept = default;
};

}  // namespace hedgehog::device
