// SPDX-License-Identifier: MIT
// How many levels people can tell apart between two ends of a range. The thesis (section 3.2.4)
// states "about 10" of force and "about 20" of speed without a formula; these are the candidates.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::study {

enum class Spacing {
  kWeber,          // steps of a constant fraction of the level
  kConstant,       // steps of one size in the unit
  kWeberTwoPrime,  // Weber steps of d' = 2; 80 % in two intervals is d' = 1.19
};

/// `steps` whole and fractional; `levels` = floor(steps) + 1.
struct LevelCount {
  double steps = 0.0;
  int levels = 0;
};

/// None at all of an empty range or a fraction that is not above 0. `reference`: the level at which
/// the fraction was measured, and at which a constant step has its size. `apart`: so many just
/// noticeable differences between neighbours.
LevelCount count_levels(double low, double high, double fraction, Spacing spacing, double reference,
                        double apart = 1.0);

/// One row of the table that lays the thesis' numbers beside the formulas.
struct LevelFormula {
  std::string range;    // "2.1 to 15 A"
  std::string formula;  // "Weber: 1 + floor(ln(hi/lo) / ln(1+w))"
  LevelCount count{};
  std::string remark{};
};

/// For a threshold in A, Weber fractions of force and speed, and the ball's most current.
std::vector<LevelFormula> level_formulas(double threshold_a, double force_fraction,
                                         double speed_fraction, double max_a = 15.0,
                                         double continuous_a = 5.0, double reference_pins_s = 10.0);

/// What the table cannot show: which range of speed 20 steps would need, and what follows for the
/// thesis' two numbers. A sentence a line.
std::vector<std::string> level_remarks(double threshold_a, double force_fraction,
                                       double speed_fraction, double max_a = 15.0,
                                       double continuous_a = 5.0, double reference_pins_s = 10.0);

}  // namespace hedgehog::study
