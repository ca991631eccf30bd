// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/winding_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "model/tick.h"
#include "model/vec3.h"

namespace hedgehog::client {
namespace {

using Phasor = std::complex<double>;

struct Mean {
  double current_a = 0.0;
  double voltage_v = 0.0;
};

Mean mean_of(const std::vector<WindingSample>& samples) {
  Mean mean;
  for (const WindingSample& one : samples) {
    mean.current_a += one.current_a;
    mean.voltage_v += one.voltage_v;
  }
  const auto count = static_cast<double>(samples.size());
  return {mean.current_a / count, mean.voltage_v / count};
}

/// Variance of the mean current.
double mean_variance(const std::vector<WindingSample>& samples) {
  const double mean_a = mean_of(samples).current_a;
  const auto count = static_cast<double>(samples.size());
  double squares = 0.0;
  for (const WindingSample& one : samples) squares += std::pow(one.current_a - mean_a, 2.0);
  return squares / (count * std::max(1.0, count - 1.0));
}

struct Sine {
  Phasor phasor;
  /// Standard errors of its two parts, and how these are correlated.
  double real_error = 0.0, imaginary_error = 0.0;
  double correlation = 0.0;
};

/// Least-squares fit of x(t) = c + Re(P exp(i w t)).
std::optional<Sine> fit_sine(const std::vector<WindingSample>& samples, double omega,
                             double WindingSample::*what) {
  // By default a `Mat3` is the unit matrix.
  model::Mat3 normal{{{}, {}, {}}};
  model::Vec3 right{};
  const auto basis_at = [&](double t_s) {
    const double angle = omega * (t_s - samples.front().t_s);
    return model::Vec3{1.0, std::cos(angle), std::sin(angle)};
  };
  for (const WindingSample& one : samples) {
    const model::Vec3 basis = basis_at(one.t_s);
    for (std::size_t row = 0; row < 3; ++row)
      normal.row[row] = normal.row[row] + basis[static_cast<int>(row)] * basis;
    right = right + one.*what * basis;
  }
  const auto count = static_cast<double>(samples.size());
  // The sample times cannot separate sine and cosine.
  if (!(model::determinant(normal) > 1e-3 * count * count * count / 4.0)) return std::nullopt;
  const model::Mat3 covariance = model::inverse(normal);
  const model::Vec3 fitted = covariance * right;
  double squares = 0.0;
  for (const WindingSample& one : samples)
    squares += std::pow(one.*what - model::dot(fitted, basis_at(one.t_s)), 2.0);
  const double variance = squares / std::max(1.0, count - 3.0);
  const double cosine = std::sqrt(covariance.row[1].y);
  const double sine = std::sqrt(covariance.row[2].z);
  return Sine{{fitted.y, -fitted.z},
              std::sqrt(variance) * cosine,
              std::sqrt(variance) * sine,
              -covariance.row[1].z / (cosine * sine)};
}

struct Response {
  Sine current, voltage;
  double omega = 0.0;
};

std::optional<Response> fit_response(const std::vector<WindingSample>& samples,
                                     double frequency_hz) {
  if (samples.size() < kMinSamples) return std::nullopt;
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  const auto current = fit_sine(samples, omega, &WindingSample::current_a);
  const auto voltage = fit_sine(samples, omega, &WindingSample::voltage_v);
  if (!current || !voltage) return std::nullopt;
  return Response{*current, *voltage, omega};
}

std::optional<Impedance> impedance_of(const Phasor& current, const Phasor& voltage, double omega) {
  // current = e * before + g * voltage, with e and g real: two equations.
  const Phasor before = current * std::polar(1.0, -omega * model::kTickSeconds);
  const double det = before.real() * voltage.imag() - before.imag() * voltage.real();
  const double e = (current.real() * voltage.imag() - current.imag() * voltage.real()) / det;
  const double g = (before.real() * current.imag() - before.imag() * current.real()) / det;
  if (!(e > 0.0 && e < 1.0 && g > 0.0)) return std::nullopt;
  const double resistance = (1.0 - e) / g;
  return Impedance{resistance, -resistance * model::kTickSeconds / std::log(e)};
}

}  // namespace

double mean_error(const std::vector<WindingSample>& samples) {
  return std::sqrt(mean_variance(samples)) / std::abs(mean_of(samples).current_a);
}

std::optional<double> steady_resistance(const std::vector<WindingSample>& forth,
                                        const std::vector<WindingSample>& back, double min_a) {
  if (forth.empty() || back.empty()) return std::nullopt;
  const Mean one = mean_of(forth);
  const Mean other = mean_of(back);
  const double current_a = one.current_a - other.current_a;
  if (std::abs(current_a) < 2.0 * min_a) return std::nullopt;
  return (one.voltage_v - other.voltage_v) / current_a;
}

double steady_resistance_error(const std::vector<WindingSample>& forth,
                               const std::vector<WindingSample>& back) {
  return std::sqrt(mean_variance(forth) + mean_variance(back)) /
         std::abs(mean_of(forth).current_a - mean_of(back).current_a);
}

std::optional<Impedance> sine_impedance(const std::vector<WindingSample>& samples,
                                        double frequency_hz) {
  const auto seen = fit_response(samples, frequency_hz);
  if (!seen) return std::nullopt;
  return impedance_of(seen->current.phasor, seen->voltage.phasor, seen->omega);
}

double inductance_error(const std::vector<WindingSample>& samples, double frequency_hz) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto seen = fit_response(samples, frequency_hz);
  if (!seen) return kUnknown;
  const Sine& current = seen->current;
  const Sine& voltage = seen->voltage;
  const double omega = seen->omega;
  const auto fitted = impedance_of(current.phasor, voltage.phasor, omega);
  if (!fitted) return kUnknown;
  const auto change = [&](Phasor off_current, Phasor off_voltage) {
    const auto off =
        impedance_of(current.phasor + off_current, voltage.phasor + off_voltage, omega);
    return off ? off->inductance_h / fitted->inductance_h - 1.0 : kUnknown;
  };
  const auto variance = [](double real, double imaginary, double correlation) {
    if (std::isinf(real) || std::isinf(imaginary)) return kUnknown;
    return real * real + imaginary * imaginary + 2.0 * correlation * real * imaginary;
  };
  // What the parts of the two phasors change when they are wrong by their standard errors.
  return std::sqrt(variance(change(current.real_error, 0.0),
                            change({0.0, current.imaginary_error}, 0.0), current.correlation) +
                   variance(change(0.0, voltage.real_error),
                            change(0.0, {0.0, voltage.imaginary_error}), voltage.correlation));
}

}  // namespace hedgehog::client
