// SPDX-License-Identifier: MIT
// A resistance that falls against the estimate, by less than any gate but always downwards, as
// turns that short one after the other make it: a cumulated sum (CUSUM, Page 1954) of V/I's
// innovations.
#pragma once

namespace hedgehog::model {

/// Of one winding. Real-time safe, trivially copyable.
class ResistanceFall {
 public:
  /// The sum at which the fall is certain.
  static constexpr double kLimit = 60.0;
  /// The most that an uncertain fall raises the winding's bound by, K.
  static constexpr double kMaxMarginK = 5.0;

  /// V/I was `deviations` standard deviations above what the filter expected.
  void add(double deviations, bool each_winding_has_a_thermistor) noexcept;
  /// `dt_s` later: what it raised the bound by goes back slowly.
  void age(double dt_s) noexcept;

  bool certain() const noexcept { return sum_ > kLimit; }
  /// What the winding's bound has to be raised by, K.
  double margin_k() const noexcept { return margin_k_; }

 private:
  double sum_ = 0.0;
  double margin_k_ = 0.0;
};

}  // namespace hedgehog::model
