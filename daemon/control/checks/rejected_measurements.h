// SPDX-License-Identifier: MIT
// The measurements that the estimate's filter rejects because they are outside its gate: the
// estimate rests on one quantity fewer, before the contradiction is a trip (estimate_check.h), or
// without ever being one.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/state/disagreement.h"
#include "model/estimate/thermal_observer.h"

namespace hedgehog::control {

/// A set of Disagreement: V/I or thermistor of a winding with the heat balance. Trivially copyable.
class RejectedSet {
 public:
  /// V/I and thermistor of each winding.
  static constexpr int kSources = 2 * model::kCoils;
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
  /// A measurement counts as rejected after this time outside its gate, and no longer after this
  /// time within it. Time without the measurement, and after a start from unknown temperatures
  /// while the estimate settles, counts for neither.
  static constexpr double kRejectedS = 0.2;
  static constexpr double kAcceptedS = 2.0;

  /// Once a tick, of `dt_s`, after the observer's step.
  void step(const model::ThermalObserver& observer, double dt_s) noexcept;
  RejectedSet rejected() const noexcept { return rejected_; }

 private:
  void follow(int index, bool rejected, double window_s) noexcept;

  RejectedSet rejected_;
  /// Time for which a measurement has been the opposite of `rejected_`, s.
  std::array<double, RejectedSet::kSources> differing_s_{};
  double window_s_ = 0.0;
};

}  // namespace hedgehog::control
