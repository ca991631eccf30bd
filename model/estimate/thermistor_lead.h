// SPDX-License-Identifier: MIT
// The thermistor's reading with a lead for its lag: smoothed, plus its slope times the lag.
#pragma once

namespace hedgehog::model {

/// Real-time safe; trivially copyable.
class ThermistorLead {
 public:
  static constexpr double kHoldS = 0.1;  // the last value is held; then the ball counts as hot

  ThermistorLead() noexcept = default;
  /// Starts at `celsius`, until the first reading.
  explicit ThermistorLead(double celsius) noexcept
      : fast_c_(celsius), slow_c_(celsius), celsius_(celsius) {}

  /// Advances by `dt_s`, at most 20 ms. The reading `shown_c` counts if it is `valid` and finite.
  void step(bool valid, double shown_c, double dt_s) noexcept;

  /// With the lead, and only smoothed.
  double celsius() const noexcept { return celsius_; }
  double smooth_c() const noexcept { return fast_c_; }
  /// No valid reading for longer than kHoldS.
  bool lost() const noexcept { return invalid_s_ > kHoldS; }

 private:
  double fast_c_ = 25.0;
  double slow_c_ = 25.0;  // the difference of the two filters is the slope
  double celsius_ = 25.0;
  double invalid_s_ = 0.0;
  bool read_ = false;
};

}  // namespace hedgehog::model
