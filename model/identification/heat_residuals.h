// SPDX-License-Identifier: MIT
// Residuals of a heat record: samples against the predictions of the four-node model.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "model/coils.h"
#include "model/identification/heat_record.h"
#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Indices into the fitted parameter vector. Parameters of the network are logarithms of their
/// ratio to the expected values.
namespace parameter {
inline constexpr Eigen::Index kCapacity = 0;    // of the windings
inline constexpr Eigen::Index kConduction = 3;  // K/W, winding to core
inline constexpr Eigen::Index kCore = 6;
inline constexpr Eigen::Index kFan = 7;
inline constexpr Eigen::Index kStill = 8;
inline constexpr Eigen::Index kLag = 9;
inline constexpr Eigen::Index kResistance = 10;  // ln of R25 relative to the given, by winding
inline constexpr Eigen::Index kOffset = 13;      // of the current sensors, A
inline constexpr Eigen::Index kLostContact = 16;
inline constexpr Eigen::Index kShared = 17;
// Of each run: ambient, K above the first reading of all runs, and initial nodes, K above the run's
// first reading.
inline constexpr Eigen::Index kAmbient = 0;
inline constexpr Eigen::Index kStart = 1;
inline constexpr Eigen::Index kOfRun = 5;
}  // namespace parameter

class HeatResiduals {
 public:
  /// Keeps a reference to `runs`. `sensor_winding`: assumed location of the thermistor.
  HeatResiduals(const std::vector<HeatRun>& runs, const std::array<double, kCoils>& r25_ohm,
                const ThermalModel& expected, int sensor_winding);

  Eigen::Index parameters() const noexcept {
    return parameter::kShared + parameter::kOfRun * static_cast<Eigen::Index>(runs_.size());
  }
  Eigen::Index measurements() const noexcept { return measurements_; }
  /// The network with parameters `p`.
  ThermalModel network(const Eigen::VectorXd& p) const;
  /// Residuals divided by their standard deviations; the first `parameters()` are those of the
  /// prior.
  Eigen::VectorXd operator()(const Eigen::VectorXd& p) const;
  /// Standard deviations of the prior.
  Eigen::VectorXd prior() const;
  /// Ambient temperature of the first run, C.
  double ambient_c(const Eigen::VectorXd& p) const;

 private:
  Eigen::Index follow(std::size_t run, const Eigen::VectorXd& p, Eigen::Index row,
                      Eigen::VectorXd& out) const;

  const std::vector<HeatRun>& runs_;
  std::array<double, kCoils> r25_ohm_;
  ThermalModel expected_;
  int sensor_winding_;
  std::vector<double> first_c_;
  Eigen::Index measurements_ = 0;
};

}  // namespace hedgehog::model
