// SPDX-License-Identifier: MIT
// The ball of 86 pins: the effect of the holes at its bottom (thesis section 2.4; reference:
// physics.md section 4).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "model/magnets/characterisation.h"
#include "tests/model/magnets/known_arrays.h"

namespace hedgehog::model {
namespace {

using testing::ElementsAre;

constexpr ForceSettings kBallSettings{ForceModel::kExact, 1e-6};

std::set<int> unstable_pins(const std::string& name) {
  std::set<int> unstable;
  for (const PinClass& pin_class : classes(name)) {
    const Characterisation character = characterise({pin_class, {}, kBallSettings});
    if (!character.stable()) unstable.insert(pin_class.pins.begin(), pin_class.pins.end());
  }
  return unstable;
}

TEST(Ball, StableAtEveryPinWithFiveOrTenShieldsRemoved) {
  EXPECT_THAT(unstable_pins("tkD-86"), testing::IsEmpty());
  EXPECT_THAT(unstable_pins("tkD-86-5"), testing::IsEmpty());
}

TEST(Ball, TenPinsOfTheRimAreExpelledWithAllTwentyRemoved) {
  EXPECT_THAT(unstable_pins("tkD-86-20"), ElementsAre(76, 77, 78, 79, 80, 81, 82, 83, 84, 85));
}

const PinClass& class_with(const std::string& name, int pin) {
  const auto& all = classes(name);
  return *std::find_if(all.begin(), all.end(), [&](const PinClass& c) {
    return std::binary_search(c.pins.begin(), c.pins.end(), pin);
  });
}

TEST(Ball, RimOfTheBallWithTenShieldsRemoved) {
  struct Rim {
    const char* array;
    int pin;
    double rest_mm;
    double extension_mm;
    double within_mm;
  };
  // Pin 77 neighbours a pentagon, 76 does not; five of each.
  for (const Rim& rim :
       {Rim{"tkD-86", 77, 0.193, 0.427, 0.002}, Rim{"tkD-86", 76, 0.250, 0.556, 0.002},
        Rim{"tkD-86-5", 77, 0.10, 0.40, 0.01}, Rim{"tkD-86-5", 76, -0.04, 0.37, 0.01}}) {
    const PinClass& pin_class = class_with(rim.array, rim.pin);
    EXPECT_EQ(pin_class.pins.size(), 5u);
    const PinForce force(pin_class, {}, kBallSettings);
    const Characterisation character = characterise(force);
    EXPECT_NEAR(character.rest_mm.value(), rim.rest_mm, rim.within_mm) << rim.pin;
    EXPECT_NEAR(extension_mm(force, character, 0.4).value(), rim.extension_mm, rim.within_mm)
        << rim.pin;
  }
}

TEST(Ball, ElsewhereItBehavesSimilarly) {
  for (const PinClass& pin_class : classes("tkD-86")) {
    if (pin_class.pins.front() >= 76 || pin_class.to_shields.front().angle_deg < 11.0) continue;
    const double rest = characterise({pin_class, {}, kBallSettings}).rest_mm.value();
    EXPECT_GT(rest, 0.40);
    EXPECT_LT(rest, 0.56);
  }
}

}  // namespace
}  // namespace hedgehog::model
