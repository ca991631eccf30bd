// SPDX-License-Identifier: MIT
// An error of measurement, or of the ball itself, that a tester gives the simulated board
// (`sim.set`), sudden or growing.
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
  kResistanceGain,     // true R25 / what it was built with
  kShortedTurns,       // share of the turns, 0..0.9
  kPwmStuck,           // duty that the bridge gets while it is awake, -1..1
  kThermistorOffsetK,  // reading - true, K
  kThermistorContact,  // share of its contact that it has lost, 0..1
  kCoolingGain,        // true / built, core to room
  kHeatCapacityGain,   // true / built
  kTachGain,           // reading / true
};
inline constexpr int kSimulatorErrorKinds = 11;

/// "current_gain". nullopt: there is no such kind.
std::string_view name(SimulatorErrorKind kind) noexcept;
std::optional<SimulatorErrorKind> simulator_error_kind(std::string_view name) noexcept;

/// What `value` may be. Trivially copyable.
struct SimulatorErrorRange {
  double min = 0.0;
  double max = 0.0;
  /// The value at which nothing is wrong.
  double none = 0.0;
  /// It touches one winding, or the thermistor on it.
  bool of_winding = false;
};
SimulatorErrorRange range_of(SimulatorErrorKind kind) noexcept;

struct SimulatorError {
  SimulatorErrorKind kind = SimulatorErrorKind::kCurrentGain;
  /// 0..2; of kinds that touch one winding.
  std::uint8_t coil = 0;
  double value = 1.0;
  /// It grows linearly over so many seconds of the board's time; 0: it is there at once.
  double ramp_s = 0.0;
  friend constexpr bool operator==(const SimulatorError&, const SimulatorError&) noexcept = default;
};

/// At most one of each kind on each winding is of use. Trivially copyable.
struct SimulatorErrorList {
  static constexpr std::size_t kMaxErrors = 32;
  /// Another one with each list that is set: the same errors once more begin to grow anew.
  std::uint8_t generation = 0;
  std::uint8_t count = 0;
  std::array<SimulatorError, kMaxErrors> error{};
  friend constexpr bool operator==(const SimulatorErrorList&,
                                   const SimulatorErrorList&) noexcept = default;
};

}  // namespace hedgehog::device
