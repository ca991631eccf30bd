// SPDX-License-Identifier: MIT
// Detects a resistance that drifts down against the estimate by less than any gate, as when turns
// short one after another: a cumulative sum (CUSUM, Page 1954) of the V/I innovations.
#pragma once

#include "model/estimate/winding_thermometer.h"

namespace hedgehog::model {

/// Resistance at 25 C of a winding as measured beside a thermistor after a rest. Trivially
/// copyable.
struct RestResistance {
  double ohm = 0.0;
  /// Relative decrease of it per ampere of current offset.
  double per_ampere = 0.0;
};

/// State for one winding. Real-time safe, trivially copyable.
///
/// The sum survives a trip: arming does not clear it. At rest it is suspended until the resistance
/// has been measured against a thermistor; it is cleared if the resistance is the same as before
/// the fall, and resumed otherwise.
class ResistanceFall {
 public:
  /// The sum at which the fall is certain.
  static constexpr double kLimit = 60.0;
  /// Maximum increase of the winding's bound by an uncertain fall, K.
  static constexpr double kMaxMarginK = 5.0;
  /// A resistance lower by more than this share differs from the one before the fall. References
  /// are not compared if a current offset can change their difference by more.
  static constexpr double kSameShare = 0.01;

  ResistanceFall() noexcept = default;
  /// Until the first reference: the device file's R25, ohm, and its standard deviation, a share.
  ResistanceFall(double file_ohm, double file_deviation) noexcept
      : before_{file_ohm, 0.0}, tolerance_(kSameShare + file_deviation) {}

  /// Adds a V/I innovation of `deviations` standard deviations (positive: above the prediction).
  void add(double deviations, bool each_winding_has_a_thermistor) noexcept;
  /// Advances by `dt_s`, less than a minute: the margin decays slowly.
  void age(double dt_s) noexcept;

  /// Once a step, after the winding's thermometer was updated: calls the three functions below at
  /// its rests and references. `offset_a`: maximum current offset.
  void follow(const WindingThermometer& winding, double offset_a) noexcept;
  /// The winding is at the temperature of a thermistor: the next current gives its resistance at a
  /// known temperature.
  void rest() noexcept;
  /// A reference was taken after that rest.
  void compare(const RestResistance& now, double offset_a) noexcept;
  /// No reference was taken: too little current, or too much heating.
  void resume() noexcept;

  bool certain() const noexcept { return sum_ > kLimit; }
  /// Required increase of the winding's bound, K.
  double margin_k() const noexcept { return margin_k_; }

 private:
  double sum_ = 0.0;
  double suspended_sum_ = 0.0;
  double margin_k_ = 0.0;
  /// The highest reference so far; before the first, the device file's, which has no offset error.
  RestResistance before_;
  double tolerance_ = kSameShare;
  bool by_file_ = true;
  bool comparing_ = false;
};

}  // namespace hedgehog::model
