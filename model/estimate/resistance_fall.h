// SPDX-License-Identifier: MIT
// A resistance that falls against the estimate, by less than any gate but always downwards, as
// turns that short one after the other make it: a cumulated sum (CUSUM, Page 1954) of V/I's
// innovations.
#pragma once

#include "model/estimate/winding_thermometer.h"

namespace hedgehog::model {

/// Resistance at 25 C of a winding as measured beside a thermistor after a rest. Trivially
/// copyable.
struct RestResistance {
  double ohm = 0.0;
  /// The share by which an offset of the current of 1 A lowered it.
  double per_ampere = 0.0;
};

/// Of one winding. Real-time safe, trivially copyable.
///
/// The sum outlives a trip: arming alone clears nothing. At a rest it is set aside until the
/// resistance has been measured against a thermistor; it is cleared if that is what it was before
/// the fall, and counts again otherwise.
class ResistanceFall {
 public:
  /// The sum at which the fall is certain.
  static constexpr double kLimit = 60.0;
  /// The most that an uncertain fall raises the winding's bound by, K.
  static constexpr double kMaxMarginK = 5.0;
  /// A resistance that is lower by more than this share is not the one before the fall. References
  /// whose difference an offset of the current can change by more are not compared.
  static constexpr double kSameShare = 0.01;

  ResistanceFall() noexcept = default;
  /// Until the first reference: the device file's R25, ohm, and its standard deviation, a share.
  ResistanceFall(double file_ohm, double file_deviation) noexcept
      : before_{file_ohm, 0.0}, tolerance_(kSameShare + file_deviation) {}

  /// V/I was `deviations` standard deviations above what the filter expected.
  void add(double deviations, bool each_winding_has_a_thermistor) noexcept;
  /// `dt_s` later: what it raised the bound by goes back slowly.
  void age(double dt_s) noexcept;

  /// Once a step, after the winding's thermometer: its rests and references, by the three below.
  /// The offset of the current is known within `offset_a`.
  void follow(const WindingThermometer& winding, double offset_a) noexcept;
  /// The winding has come to a rest beside a thermistor: its next current shows its resistance at a
  /// known temperature.
  void rest() noexcept;
  /// A reference was taken after that rest.
  void compare(const RestResistance& now, double offset_a) noexcept;
  /// None was taken: too little current, or too much heat.
  void resume() noexcept;

  bool certain() const noexcept { return sum_ > kLimit; }
  /// What the winding's bound has to be raised by, K.
  double margin_k() const noexcept { return margin_k_; }

 private:
  double sum_ = 0.0;
  double set_aside_ = 0.0;
  double margin_k_ = 0.0;
  /// The highest reference so far; until the first, the file's, which no offset has lowered.
  RestResistance before_;
  double tolerance_ = kSameShare;
  bool by_file_ = true;
  bool comparing_ = false;
};

}  // namespace hedgehog::model
