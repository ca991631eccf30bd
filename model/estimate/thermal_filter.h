// SPDX-License-Identifier: MIT
// Temperatures of the ball with their standard deviations: an extended Kalman filter over its four
// nodes, ambient, the thermistors, and the parameters by which this ball and its electronics differ
// from the device file. Energy balance, V/I and thermistors are weighted by their uncertainties.
#pragma once

#include <array>
#include <cstddef>

#include "model/coils.h"
#include "model/estimate/current_accuracy.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"

namespace hedgehog::model {

/// Difference between a measurement and the filter's prediction.
struct Innovation {
  double difference = 0.0;  // measured - predicted, in the measurement's own unit
  double deviations = 0.0;  // the same in standard deviations of the two combined
  bool used = false;        // false: rejected, it exceeded ThermalFilter::kGate
};

/// Initial state of the filter. Trivially copyable.
struct FilterStart {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// Standard deviation of the nodes, common to all and individual, K.
  double common_k = 0.5;
  double single_k = 0.3;
};

/// Real-time safe: about 2 us a prediction, 1 us a measurement. Trivially copyable. One thread.
class ThermalFilter {
 public:
  static constexpr double kGate = 5.0;  // deviations from which a measurement is rejected

  ThermalFilter() noexcept : ThermalFilter(CoilModel{}, ThermalModel{}, {}, {}) {}
  ThermalFilter(const CoilModel& coils, const ThermalModel& thermal,
                const ThermalUncertainty& uncertainty, const FilterStart& start) noexcept;

  /// Sets the accuracy of the currents (until then exact) and discards the estimated offsets.
  void set_current_accuracy(const CurrentAccuracy& accuracy) noexcept;

  /// Advances by `dt_s` (0.02..0.3 s) with the losses `loss_w` of the windings.
  void predict(const std::array<double, kCoils>& loss_w, bool fan_running, double dt_s) noexcept;

  /// Update with ln(R / R25) of winding `coil` (0..2) and its standard deviation; a current offset
  /// of 1 A lowers it by `per_ampere`.
  Innovation resistance(int coil, double log_ratio, double deviation, double per_ampere) noexcept;
  /// Update with the reading of the thermistor on winding `coil`.
  Innovation thermistor(int coil, double celsius) noexcept;
  /// Update with the current reading of winding `coil` while no current flows, A.
  void idle_current(int coil, double current_a) noexcept;

  ThermalState nodes() const noexcept;
  double winding_c(int coil) const noexcept { return x_[at(kWinding, coil)]; }
  /// Standard deviation of `winding_c`, K.
  double winding_deviation_k(int coil) const noexcept { return deviation(at(kWinding, coil)); }
  double core_c() const noexcept { return x_[kCore]; }
  double ambient_c() const noexcept { return x_[kAmbient]; }
  /// Standard deviation of a temperature that is `share` (0..1) of the way from ambient to core, K.
  double between_deviation_k(double share) const noexcept;
  double cooling() const noexcept;  // conductance from core to ambient relative to the file's
  /// The thermistor's own temperature, without its offset.
  double thermistor_c(int coil) const noexcept { return x_[at(kBody, coil)]; }
  double thermistor_offset_k(int coil) const noexcept { return x_[at(kThermistorOffset, coil)]; }
  /// ln of R25 relative to the device file's, including the gain errors of voltage and current.
  double resistance_drift(int coil) const noexcept { return x_[at(kResistance, coil)]; }
  double resistance_drift_deviation(int coil) const noexcept {
    return deviation(at(kResistance, coil));
  }
  double current_offset_a(int coil) const noexcept { return x_[at(kCurrentOffset, coil)]; }
  double current_offset_deviation_a(int coil) const noexcept {
    return deviation(at(kCurrentOffset, coil));
  }
  /// Present resistance of the winding as this board measures it (V/I), ohm.
  double resistance_ohm(int coil) const noexcept;

 private:
  // Index of the first element of each state; per-winding states have three.
  static constexpr std::size_t kWinding = 0;
  static constexpr std::size_t kCore = 3;
  static constexpr std::size_t kAmbient = 4;
  static constexpr std::size_t kResistance = 5;
  static constexpr std::size_t kWarming = 8;      // ln of 1 / heat capacity relative to the file's
  static constexpr std::size_t kConduction = 11;  // ln of winding-to-core conductance
  static constexpr std::size_t kCooling = 14;     // ln of core-to-ambient conductance
  static constexpr std::size_t kBody = 15;
  static constexpr std::size_t kCurrentOffset = 18;
  static constexpr std::size_t kThermistorOffset = 21;
  static constexpr std::size_t kLostContact = 24;
  static constexpr std::size_t kStates = 27;
  static constexpr std::size_t kMoving = 7;  // windings, core, bodies

  using Row = std::array<double, kStates>;
  static constexpr std::size_t at(std::size_t first, int coil) noexcept {
    return first + static_cast<std::size_t>(coil);
  }
  /// One term of a measurement: its derivative by a state.
  struct Term {
    std::size_t state;
    double derivative;
  };

  double deviation(std::size_t state) const noexcept;
  void set_variance(std::size_t state, double deviation) noexcept;
  void start_nodes(const FilterStart& start) noexcept;
  std::array<double, kMoving> move(const std::array<double, kCoils>& loss_w, bool fan_running,
                                   double dt_s, std::array<Row, kMoving>& jacobian) noexcept;
  void propagate(const std::array<Row, kMoving>& jacobian) noexcept;
  void spread(double dt_s) noexcept;
  template <std::size_t N>
  Innovation measure(const std::array<Term, N>& terms, double difference,
                     double deviation) noexcept;
  void limit_state() noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  double max_offset_a_ = 0.0;
  Row x_{};
  std::array<Row, kStates> p_{};
};

}  // namespace hedgehog::model
