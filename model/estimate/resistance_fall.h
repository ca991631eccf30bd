// SPDX-License-Identifier: MIT
// Detects a resistance that drifts down against the estimate by less than any gate, as when turns
// short one after another: a cumulative sum (CUSUM, Page 1954) of the V/I innovations.
#pragma once

#include "model/estimate/winding_thermometer.h"

namespace hedgehog::model {

/// R25 of a winding as measured beside a thermistor after a rest. Trivially copyable.
struct RestResistance {
  double ohm = 0.0;
  double per_ampere = 0.0;  // its relative decrease per ampere of current offset
};

/// State for one winding. Real-time safe, trivially copyable. The sum survives a trip and arming; a
/// rest suspends it until the resistance has been measured against a thermistor: it is cleared if
/// the resistance is the same as before the fall, and resumed otherwise.
class ResistanceFall {
 public:
  static constexpr double kLimit = 60.0;      // the sum at which the fall is certain
  static constexpr double kMaxMarginK = 5.0;  // added to the winding's bound by an uncertain fall
  /// A resistance lower by more than this share differs from the one before the fall. References
  /// are not compared if a current offset can change their difference by more.
  static constexpr double kSameShare = 0.01;

  ResistanceFall() noexcept = default;
  /// R25 of the device file, used until the first reference, and its relative standard deviation.
  ResistanceFall(double file_ohm, double file_deviation) noexcept
      : before_{file_ohm, 0.0}, tolerance_(kSameShare + file_deviation) {}

  /// Adds a V/I innovation in standard deviations (positive: above the prediction).
  void add(double deviations, bool each_winding_has_a_thermistor) noexcept;
  /// Slow decay of the margin over `dt_s`, less than a minute.
  void age(double dt_s) noexcept;

  /// Once a step, after the winding's thermometer: calls the next three at its rests and
  /// references. `offset_a`: maximum current offset.
  void follow(const WindingThermometer& winding, double offset_a) noexcept;
  void rest() noexcept;  // the winding is at the temperature of a thermistor
  /// After that rest a reference was taken; or none was: too little current, or too much heating.
  void compare(const RestResistance& now, double offset_a) noexcept;
  void resume() noexcept;

  bool certain() const noexcept { return sum_ > kLimit; }
  double margin_k() const noexcept { return margin_k_; }

 private:
  double sum_ = 0.0;
  double suspended_sum_ = 0.0;
  double margin_k_ = 0.0;
  RestResistance before_;  // highest reference so far; at first the file's, without offset error
  double tolerance_ = kSameShare;
  bool by_file_ = true;
  bool comparing_ = false;
};

}  // namespace hedgehog::model
