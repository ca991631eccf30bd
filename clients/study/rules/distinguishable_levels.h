// SPDX-License-Identifier: MIT
// Number of levels that people can distinguish within a range. The thesis (section 3.2.4) states
// "about 10" of force and "about 20" of speed without a formula; these are the candidates.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::study {

enum class Spacing {
  kWeber,          // steps of a constant fraction of the level
  kConstant,       // steps of one size in the unit
  kWeberTwoPrime,  // Weber steps of d' = 2; 80 % in two intervals is d' = 1.19
};

/// `steps` with fraction; `levels` = floor(steps) + 1.
struct LevelCount {
  double steps = 0.0;
  int levels = 0;
};

/// Zero steps for an empty range or a fraction that is not above 0. `reference`: the level at which
/// the fraction was measured, and at which a constant step has its size. `apart`: number of just
/// noticeable differences between neighbours.
LevelCount count_levels(double low, double high, double fraction, Spacing spacing, double reference,
                        double apart = 1.0);

/// One row of the table that compares the thesis' numbers with the formulas.
struct LevelFormula {
  std::string range;    // "2.1 to 15 A"
  std::string formula;  // "Weber: 1 + floor(ln(hi/lo) / ln(1+w))"
  LevelCount count{};
  std::string remark{};
};

/// For a threshold in A, Weber fractions of force and speed, and the ball's maximum current.
std::vector<LevelFormula> level_formulas(double threshold_a, double force_fraction,
                                         double speed_fraction, double max_a = 15.0,
                                         double continuous_a = 5.0, double reference_pins_s = 10.0);

/// Remarks on the table: which range of speed 20 steps would need, and what follows for the thesis'
/// two numbers. One sentence per line.
std::vector<std::string> level_remarks(double threshold_a, double force_fraction,
                                       double speed_fraction, double max_a = 15.0,
                                       double continuous_a = 5.0, double reference_pins_s = 10.0);

}  // namespace hedgehog::study
