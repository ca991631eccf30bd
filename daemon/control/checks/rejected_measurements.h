// SPDX-License-Identifier: MIT
// Measurements that the estimate's filter rejects as outside its gate: the estimate rests on one
// quantity fewer, before the contradiction is a trip (estimate_check.h), or without becoming one.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/state/disagreement.h"
#include "model/estimate/thermal_observer.h"

namespace hedgehog::control {

/// A set of Disagreement: V/I or thermistor of a winding with the heat balance. Trivially copyable.
class RejectedSet {
 public:
  static constexpr int kSources = 2 * model::kCoils;  // V/I and thermistor of each winding
  /// The disagreement of source 0..kSources - 1.
  static constexpr Disagreement source(int index) noexcept {
    return {index / 2, index % 2 == 0 ? Quantity::kResistance : Quantity::kThermistor,
            Quantity::kHeatBalance};
  }

  constexpr bool contains(int index) const noexcept { return (bits_ >> index & 1u) != 0; }
  constexpr void set(int index, bool rejected) noexcept {
    const unsigned bit = 1u << index;
    bits_ = static_cast<std::uint8_t>(rejected ? bits_ | bit : bits_ & ~bit);
  }
  friend constexpr bool operator==(RejectedSet, RejectedSet) noexcept = default;

 private:
  std::uint8_t bits_ = 0;
};

/// Control thread; real-time safe, trivially copyable.
class RejectedMeasurements {
 public:
  /// Filter windows (0.1 s) outside the gate until rejected, within it until accepted. Not counted:
  /// without the measurement, and while the estimate settles from unknown temperatures.
  static constexpr int kRejectedWindows = 2;
  static constexpr int kAcceptedWindows = 20;

  /// Once a tick, after the observer's step.
  void step(const model::ThermalObserver& observer) noexcept;
  RejectedSet rejected() const noexcept { return rejected_; }

 private:
  void follow(int index, bool rejected) noexcept;

  RejectedSet rejected_;
  /// Windows in which a measurement has been the opposite of `rejected_`.
  std::array<int, RejectedSet::kSources> differing_windows_{};
};

}  // namespace hedgehog::control
