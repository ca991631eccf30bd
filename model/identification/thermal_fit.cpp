// SPDX-License-Identifier: MIT
#include "model/identification/thermal_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/identification/heat_residuals.h"
#include "model/thermal/thermal_uncertainty.h"

namespace hedgehog::model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxIterations = 30;
constexpr double kConverged = 1e-6;
constexpr double kDerivativeStep = 1e-4;
/// Standard deviations, and relative model error of four nodes, in the stated uncertainty.
constexpr double kClaimDeviations = 2.5;
constexpr double kModelShare = 0.02;
constexpr double kMaxMisfit = 5.0;
/// Uncertainty of an uncalibrated ball; a fit must not be worse.
constexpr double kMaxFoundShare = 0.2;
/// Minimum increase of the sum of squares for the thermistor on any other winding.
constexpr double kCertain = 25.0;
/// Minimum number of measurements, and minimum heat in each winding, for a determined fit.
constexpr Index kMinMeasurements = 300;
constexpr double kMinHeatJ = 200.0;

struct Solution {
  VectorXd p;
  double squares = std::numeric_limits<double>::infinity();
  MatrixXd normal;
};

MatrixXd jacobian(const HeatResiduals& residuals, const VectorXd& p, const VectorXd& at_p) {
  MatrixXd j(at_p.size(), p.size());
  for (Index k = 0; k < p.size(); ++k) {
    VectorXd moved = p;
    moved[k] += kDerivativeStep;
    j.col(k) = (residuals(moved) - at_p) / kDerivativeStep;
  }
  return j;
}

/// Levenberg-Marquardt.
Solution solve(const HeatResiduals& residuals, VectorXd p) {
  Solution best{std::move(p), 0.0, {}};
  VectorXd left = residuals(best.p);
  best.squares = left.squaredNorm();
  double damping = 1e-3;
  for (int i = 0; i < kMaxIterations; ++i) {
    const MatrixXd j = jacobian(residuals, best.p, left);
    best.normal = j.transpose() * j;
    const VectorXd slope = j.transpose() * left;
    bool settled = false;
    for (;;) {
      MatrixXd damped = best.normal;
      damped.diagonal() *= 1.0 + damping;
      const VectorXd step = damped.ldlt().solve(-slope);
      const VectorXd tried = best.p + step;
      const VectorXd then = residuals(tried);
      const double squares = then.squaredNorm();
      if (std::isfinite(squares) && squares < best.squares) {
        settled = best.squares - squares < kConverged * best.squares;
        best.p = tried;
        best.squares = squares;
        left = then;
        damping = std::max(1e-9, 0.1 * damping);
        break;
      }
      damping *= 10.0;
      settled = damping > 1e6;
      if (settled) break;
    }
    if (settled) break;
  }
  return best;
}

bool determined(const std::vector<HeatRun>& runs, const HeatResiduals& residuals) {
  std::array<double, kCoils> heat_j{};
  for (const HeatRun& run : runs) {
    for (const HeatSample& sample : run.samples)
      for (std::size_t i = 0; i < heat_j.size(); ++i) heat_j[i] += sample.power_w[i] * sample.dt_s;
  }
  return residuals.measurements() >= kMinMeasurements &&
         *std::min_element(heat_j.begin(), heat_j.end()) >= kMinHeatJ;
}

ThermalFound found_by(const Solution& solution, const HeatResiduals& residuals) {
  ThermalFound found;
  found.thermal = residuals.network(solution.p);
  found.ambient_c = residuals.ambient_c(solution.p);
  found.misfit = std::sqrt(solution.squares / static_cast<double>(residuals.measurements()));
  const MatrixXd covariance = solution.normal.ldlt().solve(
      MatrixXd::Identity(solution.normal.rows(), solution.normal.cols()));
  // A misfit above 1 widens the uncertainties accordingly.
  const double wider = std::max(1.0, found.misfit);
  const auto deviation = [&](Index k) { return wider * std::sqrt(covariance(k, k)); };
  double worst = 0.0;
  const auto deviation_of = [&](Index k) {
    worst = std::max(worst, deviation(k));
    return deviation(k);
  };
  for (std::size_t i = 0; i < kCoils; ++i) {
    const auto k = static_cast<Index>(i);
    found.deviation.winding_j_k[i] = deviation_of(parameter::kCapacity + k);
    found.deviation.winding_to_core_k_w[i] = deviation_of(parameter::kConduction + k);
    found.resistance_gain[i] = std::exp(solution.p[parameter::kResistance + k]);
  }
  found.deviation.core_j_k = deviation_of(parameter::kCore);
  found.deviation.core_to_ambient_fan_k_w = deviation_of(parameter::kFan);
  found.deviation.core_to_ambient_still_k_w = deviation(parameter::kStill);
  found.deviation.sensor_lag_s = deviation(parameter::kLag);
  const auto within = [](double deviation_share) {
    return std::clamp(kClaimDeviations * deviation_share + kModelShare, kMinUncertainty.thermal,
                      kMaxUncertainty.thermal);
  };
  found.uncertainty = within(worst);
  found.still_uncertainty = within(found.deviation.core_to_ambient_still_k_w);
  return found;
}

}  // namespace

std::optional<ThermalFound> fit_thermal(const std::vector<HeatRun>& runs,
                                        const std::array<double, kCoils>& r25_ohm,
                                        const ThermalModel& expected) {
  if (runs.empty()) return std::nullopt;
  std::optional<ThermalFound> found;
  double lowest = std::numeric_limits<double>::infinity();
  double next = lowest;
  for (int sensor = 0; sensor < kCoils; ++sensor) {
    const HeatResiduals residuals(runs, r25_ohm, expected, sensor);
    if (!determined(runs, residuals)) return std::nullopt;
    const Solution solution = solve(residuals, VectorXd::Zero(residuals.parameters()));
    next = std::min(next, std::max(lowest, solution.squares));
    if (solution.squares >= lowest) continue;
    lowest = solution.squares;
    found = found_by(solution, residuals);
  }
  if (!found || !(found->misfit <= kMaxMisfit) || !(found->uncertainty <= kMaxFoundShare))
    return std::nullopt;
  found->sensor_certain = next - lowest > kCertain;
  return found;
}

}  // namespace hedgehog::model
