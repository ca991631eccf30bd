// SPDX-License-Identifier: MIT
// Purpose of the pin classes: the force curves of an array in little time.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <vector>

#include "model/magnets/force_curve.h"
#include "tests/model/magnets/known_arrays.h"

namespace hedgehog::model {
namespace {

// Both computations run alternately in one process; the minimum processor time of up to five runs
// each is compared, because other load only adds to it. The ratio is about 130.
TEST(ForceCurve, ByClassesIsManyTimesAsFastAsPinByPin) {
  const ForceSettings settings{ForceModel::kExact, 1e-3};
  const Arrangement& tkd = arrangement("tkD");
  const ArraySizes sizes;
  double sum_n = 0.0;
  const auto add = [&](const std::vector<MagnetSite>& others, const MagnetPair& pair) {
    for (const double offset_mm : kThesisGrid.offsets_mm()) {
      for (const MagnetSite& other : others) {
        const double apart_deg = angle_deg(tkd.pins.front().direction, other.direction);
        if (apart_deg > 1.0)
          sum_n += pair_force(pair, {apart_deg, offset_mm, 0.0}, settings).force_n;
      }
    }
  };
  double all_pins = std::numeric_limits<double>::infinity();
  double by_class = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 5 && !(all_pins > 25.0 * by_class); ++turn) {
    const std::clock_t start = std::clock();
    add(tkd.pins, sizes.pin_and_pin());
    add(tkd.shields, sizes.pin_and_shield());
    const std::clock_t middle = std::clock();
    constexpr int kRuns = 5;
    for (int run = 0; run < kRuns; ++run)
      for (const PinClass& pin_class : symmetry_classes(tkd))
        sum_n += force_curve({pin_class, sizes, settings}).force_n.front();
    by_class = std::min(by_class, static_cast<double>(std::clock() - middle) / kRuns);
    all_pins = std::min(all_pins,
                        static_cast<double>(middle - start) * static_cast<double>(tkd.pins.size()));
  }
  EXPECT_GT(all_pins, 25.0 * by_class);
}

}  // namespace
}  // namespace hedgehog::model
