// SPDX-License-Identifier: MIT
// Second-order filters; Butterworth low and high passes are cascades of them.
#pragma once

#include <cmath>
#include <numbers>

namespace hedgehog::sound {

/// One section in transposed direct form II. Coefficients: R. Bristow-Johnson, "Cookbook formulae
/// for audio equalizer biquad filter coefficients".
class Biquad {
 public:
  enum class Kind { kLowPass, kHighPass };

  /// REQUIRES: `corner_hz` below half of `rate_hz`.
  Biquad(Kind kind, double corner_hz, double rate_hz, double q) {
    const double w = 2.0 * std::numbers::pi * corner_hz / rate_hz;
    const double alpha = std::sin(w) / (2.0 * q);
    const double a0 = 1.0 + alpha;
    const double edge = kind == Kind::kLowPass ? 1.0 - std::cos(w) : 1.0 + std::cos(w);
    b1_ = (kind == Kind::kLowPass ? edge : -edge) / a0;
    b0_ = 0.5 * edge / a0;
    a1_ = -2.0 * std::cos(w) / a0;
    a2_ = (1.0 - alpha) / a0;
  }

  double next(double in) noexcept {
    const double out = b0_ * in + z1_;
    z1_ = b1_ * in - a1_ * out + z2_;
    z2_ = b0_ * in - a2_ * out;
    return out;
  }

 private:
  double b0_ = 1.0;  // and b2
  double b1_ = 0.0;
  double a1_ = 0.0;
  double a2_ = 0.0;
  double z1_ = 0.0;
  double z2_ = 0.0;
};

/// A fourth-order Butterworth filter (24 dB per octave).
class FourthOrder {
 public:
  FourthOrder(Biquad::Kind kind, double corner_hz, double rate_hz)
      : first_(kind, corner_hz, rate_hz, 0.541196), second_(kind, corner_hz, rate_hz, 1.306563) {}

  double next(double in) noexcept { return second_.next(first_.next(in)); }

 private:
  Biquad first_;
  Biquad second_;
};

}  // namespace hedgehog::sound
