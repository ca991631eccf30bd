// SPDX-License-Identifier: MIT
#include "model/identification/heat_residuals.h"

#include <algorithm>
#include <cmath>

#include "model/thermal/thermal_flow.h"

namespace hedgehog::model {
namespace {

// Standard deviations of the prior. Wide for the network: wider than the spread between balls of a
// kind.
constexpr double kNetworkShare = 0.4;
constexpr double kStartLagShare = 0.7;
constexpr double kResistanceShare = 0.05;
constexpr double kOffsetA = 0.1;
constexpr double kLostContactShare = 0.05;
constexpr double kAmbientWidthK = 5.0;
constexpr double kRestedK = 0.3;
constexpr double kUnknownStartK = 15.0;

// Noise of one current measurement, and additional relative error of V/I of a sample.
constexpr double kCurrentNoiseA = 0.05;
constexpr double kReadingShare = 0.001;
// Thermistor error by lag, rounding and contact with other parts.
constexpr double kSensorK = 0.15;
/// Minimum current to determine a resistance, A.
constexpr double kInformativeA = 1.0;
constexpr double kLongestStepS = 0.5;

bool informative(const HeatSample& sample, std::size_t i) {
  return sample.count > 0 && std::abs(sample.current_a[i]) >= kInformativeA;
}

double resistance_error(const HeatSample& sample, std::size_t i) {
  const double noise = kCurrentNoiseA / std::abs(sample.current_a[i]) / std::sqrt(sample.count);
  return std::hypot(noise, kReadingShare);
}

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace

HeatResiduals::HeatResiduals(const std::vector<HeatRun>& runs,
                             const std::array<double, kCoils>& r25_ohm,
                             const ThermalModel& expected, int sensor_winding)
    : runs_(runs), r25_ohm_(r25_ohm), expected_(expected), sensor_winding_(sensor_winding) {
  for (const HeatRun& run : runs) {
    double first_c = 25.0;
    const auto shown = std::find_if(run.samples.begin(), run.samples.end(),
                                    [](const HeatSample& one) { return one.sensor_c.has_value(); });
    if (shown != run.samples.end()) first_c = *shown->sensor_c;
    first_c_.push_back(first_c);
    for (const HeatSample& sample : run.samples) {
      measurements_ += sample.sensor_c ? 1 : 0;
      for (std::size_t i = 0; i < kCoils; ++i) measurements_ += informative(sample, i) ? 1 : 0;
    }
  }
}

Eigen::VectorXd HeatResiduals::prior() const {
  Eigen::VectorXd p = Eigen::VectorXd::Constant(parameters(), kNetworkShare);
  p[parameter::kLag] = kStartLagShare;
  p.segment<3>(parameter::kResistance).setConstant(kResistanceShare);
  p.segment<3>(parameter::kOffset).setConstant(kOffsetA);
  p[parameter::kLostContact] = kLostContactShare;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const Eigen::Index own = parameter::kShared + parameter::kOfRun * index(run);
    p[own + parameter::kAmbient] = kAmbientWidthK;
    const double start_k = runs_[run].began_at_rest ? kRestedK : kUnknownStartK;
    p.segment<4>(own + parameter::kStart).setConstant(start_k);
  }
  return p;
}

ThermalModel HeatResiduals::network(const Eigen::VectorXd& p) const {
  ThermalModel m = expected_;
  for (std::size_t i = 0; i < kCoils; ++i) {
    m.winding_j_k[i] *= std::exp(p[parameter::kCapacity + index(i)]);
    m.winding_to_core_k_w[i] *= std::exp(p[parameter::kConduction + index(i)]);
  }
  m.core_j_k *= std::exp(p[parameter::kCore]);
  m.core_to_ambient_fan_k_w *= std::exp(p[parameter::kFan]);
  m.core_to_ambient_still_k_w *= std::exp(p[parameter::kStill]);
  m.sensor_lag_s *= std::exp(p[parameter::kLag]);
  m.sensor_winding = sensor_winding_;
  return m;
}

double HeatResiduals::ambient_c(const Eigen::VectorXd& p) const {
  return first_c_.front() + p[parameter::kShared + parameter::kAmbient];
}

Eigen::VectorXd HeatResiduals::operator()(const Eigen::VectorXd& p) const {
  Eigen::VectorXd out(parameters() + measurements_);
  out.head(parameters()) = p.cwiseQuotient(prior());
  Eigen::Index row = parameters();
  for (std::size_t run = 0; run < runs_.size(); ++run) row = follow(run, p, row, out);
  return out;
}

Eigen::Index HeatResiduals::follow(std::size_t run, const Eigen::VectorXd& p, Eigen::Index row,
                                   Eigen::VectorXd& out) const {
  const ThermalModel network = this->network(p);
  const Eigen::Index own = parameter::kShared + parameter::kOfRun * index(run);
  const auto sensor = static_cast<std::size_t>(sensor_winding_);
  ThermalState nodes;
  for (std::size_t i = 0; i < kCoils; ++i)
    nodes.winding_c[i] = first_c_[run] + p[own + parameter::kStart + index(i)];
  nodes.core_c = first_c_[run] + p[own + parameter::kStart + 3];
  double body_c = first_c_[run];
  HeatLoad load;
  load.ambient_c = first_c_.front() + p[own + parameter::kAmbient];
  for (const HeatSample& sample : runs_[run].samples) {
    load.fan_running = sample.fan_running;
    for (std::size_t i = 0; i < kCoils; ++i) {
      const double offset_a = p[parameter::kOffset + index(i)];
      load.loss_w[i] = sample.power_w[i] - offset_a * sample.voltage_v[i];
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(sample.dt_s / kLongestStepS)));
    const double dt_s = sample.dt_s / steps;
    const double keep = std::exp(-dt_s / network.sensor_lag_s);
    std::array<double, kCoils> mean_c{};
    double shown_c = 0.0;
    for (int k = 0; k < steps; ++k) {
      const auto rates = heating_rates(network, nodes, load);
      const auto middle = advanced(nodes, rates, 0.5 * dt_s);
      nodes = advanced(nodes, heating_rates(network, middle, load), dt_s);
      const double lost = p[parameter::kLostContact];
      const double at_c =
          middle.winding_c[sensor] + lost * (middle.core_c - middle.winding_c[sensor]);
      const double before_c = body_c;
      body_c = at_c + (body_c - at_c) * keep;
      shown_c += 0.5 * (before_c + body_c) / steps;
      for (std::size_t i = 0; i < kCoils; ++i) mean_c[i] += middle.winding_c[i] / steps;
    }
    if (sample.sensor_c) out[row++] = (*sample.sensor_c - shown_c) / kSensorK;
    for (std::size_t i = 0; i < kCoils; ++i) {
      if (!informative(sample, i)) continue;
      const double true_a = sample.current_a[i] - p[parameter::kOffset + index(i)];
      const double r25 = r25_ohm_[i] * std::exp(p[parameter::kResistance + index(i)]);
      const double expected = resistance_at(Ohms(r25), Celsius(mean_c[i])).value;
      const double measured = sample.voltage_v[i] / true_a;
      out[row++] = (measured / expected - 1.0) / resistance_error(sample, i);
    }
  }
  return row;
}

}  // namespace hedgehog::model
