// SPDX-License-Identifier: MIT
// Temperatures of the ball with their standard deviations: an extended Kalman filter over its four
// nodes, the room, the thermistors, and the parameters by which this ball and its electronics
// differ from the device file. Energy balance, V/I and thermistors count by their uncertainties.
#pragma once

#include <array>
#include <cstddef>

#include "model/coils.h"
#include "model/estimate/current_accuracy.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"

namespace hedgehog::model {

/// A measurement against what the filter expected of it.
struct Innovation {
  /// Measured - expected, in the measurement's own unit and in standard deviations of both.
  double difference = 0.0;
  double deviations = 0.0;
  /// It was used. Not when it was further off than ThermalFilter::kGate.
  bool used = false;
};

/// How the filter begins. Trivially copyable.
struct FilterStart {
  ThermalState nodes;
  double ambient_c = 25.0;
  /// Standard deviation of the nodes, together and each for itself, K.
  double common_k = 0.5;
  double single_k = 0.3;
};

/// Real-time safe: no allocation, about 2 us a prediction and 1 us a measurement. Trivially
/// copyable. One thread.
class ThermalFilter {
 public:
  /// Further off than so many standard deviations a measurement is not used.
  static constexpr double kGate = 5.0;

  ThermalFilter() noexcept : ThermalFilter(CoilModel{}, ThermalModel{}, {}, {}) {}
  ThermalFilter(const CoilModel& coils, const ThermalModel& thermal,
                const ThermalUncertainty& uncertainty, const FilterStart& start) noexcept;

  /// How well the board knows its currents; forgets what was learned of their offsets.
  void set_current_accuracy(const CurrentAccuracy& accuracy) noexcept;

  /// `dt_s` (0.02..0.3 s) later, in which the windings lost `loss_w` as heat.
  void predict(const std::array<double, kCoils>& loss_w, bool fan_running, double dt_s) noexcept;

  /// Winding `coil` (0..2) showed ln(R / R25) with this standard deviation; an offset of the
  /// current of 1 A lowers it by `per_ampere`.
  Innovation resistance(int coil, double log_ratio, double deviation, double per_ampere) noexcept;
  /// The thermistor on winding `coil` showed this.
  Innovation thermistor(int coil, double celsius) noexcept;
  /// While nothing flows in winding `coil` its sensor shows this, A.
  void idle_current(int coil, double current_a) noexcept;

  ThermalState nodes() const noexcept;
  double winding_c(int coil) const noexcept { return x_[at(kWinding, coil)]; }
  /// Standard deviation of it, K.
  double winding_deviation_k(int coil) const noexcept { return deviation(at(kWinding, coil)); }
  double core_c() const noexcept { return x_[kCore]; }
  double ambient_c() const noexcept { return x_[kAmbient]; }
  /// Standard deviation of a temperature that is `share` (0..1) of the way from room to core, K.
  double between_deviation_k(double share) const noexcept;
  /// Conductance from core to room against the device file's.
  double cooling() const noexcept;
  /// The thermistor's own temperature, without its offset.
  double thermistor_c(int coil) const noexcept { return x_[at(kBody, coil)]; }
  double thermistor_offset_k(int coil) const noexcept { return x_[at(kThermistorOffset, coil)]; }
  /// ln of R25 against the device file's, with the gains of voltage and current in it.
  double resistance_drift(int coil) const noexcept { return x_[at(kResistance, coil)]; }
  double resistance_drift_deviation(int coil) const noexcept {
    return deviation(at(kResistance, coil));
  }
  double current_offset_a(int coil) const noexcept { return x_[at(kCurrentOffset, coil)]; }
  double current_offset_deviation_a(int coil) const noexcept {
    return deviation(at(kCurrentOffset, coil));
  }
  /// What the winding's resistance is now, as a voltage and a current of this board show it, ohm.
  double resistance_ohm(int coil) const noexcept;

 private:
  // Where each state begins; those with one of each winding have three.
  static constexpr std::size_t kWinding = 0;
  static constexpr std::size_t kCore = 3;
  static constexpr std::size_t kAmbient = 4;
  static constexpr std::size_t kResistance = 5;
  static constexpr std::size_t kWarming = 8;      // ln of 1 / capacity against the file's
  static constexpr std::size_t kConduction = 11;  // ln of winding-to-core conductance
  static constexpr std::size_t kCooling = 14;     // ln of core-to-room conductance
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
  void keep_plausible() noexcept;

  CoilModel coils_;
  ThermalModel thermal_;
  double max_offset_a_ = 0.2;
  Row x_{};
  std::array<Row, kStates> p_{};
};

}  // namespace hedgehog::model
