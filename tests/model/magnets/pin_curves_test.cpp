// SPDX-License-Identifier: MIT
#include "model/magnets/ball_geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/geometry/field.h"
#include "model/magnets/characterisation.h"
#include "model/magnets/electromagnet.h"
#include "tests/model/magnets/known_arrays.h"

namespace hedgehog::model {
namespace {

constexpr ForceSettings kPinSettings{ForceModel::kExact, 1e-6};
constexpr double kThesisForceN = 15.0 * kFeaCalibration.force_slope_n_a;

/// Slope from the thesis' simulation, for the typical pin at its rest.
double fea_slope_n_a() {
  return coil_force_n(fea_electromagnet(), 1.0, kThesisPinMagnet, 35.0, 0.0,
                      thesis_ball().curves.typical_rest_mm());
}

// Table lookup against the exact solution, pin by pin. A pin that rests below the shell starts from
// the shell.
TEST(PinCurves, AgreeWithTheExactExtension) {
  const PinCurves& curves = thesis_ball().curves;
  ASSERT_EQ(curves.size(), 86u);
  for (const PinClass& pin_class : classes("tkD-86")) {
    const PinForce force(pin_class, {}, kPinSettings);
    const Characterisation character = characterise(force);
    const double rest = character.standing_mm.value();
    EXPECT_EQ(rest, std::max(0.0, *character.rest_mm));
    for (const int pin : pin_class.pins) {
      const auto at = static_cast<std::size_t>(pin);
      EXPECT_NEAR(curves.rest_mm(at), rest, 1e-3) << pin;
      for (const double current_a : {5.0, 15.0}) {
        const double push = current_a * fea_slope_n_a();
        const double out = *extension_mm(force, character, fea_electromagnet(), current_a);
        const double expected = std::max(0.0, *character.rest_mm + out) - rest;
        EXPECT_NEAR(curves.extension_mm(at, push), expected, 1e-3) << pin;
        const Push coil = coil_push(fea_electromagnet(), current_a, {});
        EXPECT_NEAR(stroke(force, character, coil)->extension_mm, expected, 1e-5) << pin;
        EXPECT_NEAR(curves.force_at_rest_n(at, push), coil(rest), 1e-4) << pin;
      }
    }
  }
}

// Reference: physics.md section 3: 0.19 N to lift a pentagon's pin off the shell, for the full
// array.
TEST(PinCurves, APentagonsPinIsOnTheShell) {
  const PinCurves tkd(arrangement("tkD"), {});
  EXPECT_EQ(tkd.rest_mm(0), 0.0);
  // The force on the typical pin, 0.5 mm farther out, is 5 % lower.
  for (const double on_it_n : {0.18, 0.19, 0.20}) {
    const double typical_n = on_it_n / tkd.force_at_rest_n(0, 1.0);
    EXPECT_NEAR(typical_n / on_it_n, 1.0 / 1.054, 1e-3);
    EXPECT_EQ(tkd.extension_mm(0, typical_n) > 0.0, on_it_n > 0.192) << on_it_n;
  }
}

TEST(PinCurves, EndsOfTheTravel) {
  const PinCurves& curves = thesis_ball().curves;
  for (std::size_t pin = 0; pin < curves.size(); ++pin) {
    EXPECT_EQ(curves.offset_mm(pin, 10.0), 1.5);
    EXPECT_EQ(curves.offset_mm(pin, -10.0), 0.0);
    EXPECT_EQ(curves.offset_mm(pin, std::numeric_limits<double>::infinity()), 1.5);
    EXPECT_EQ(curves.offset_mm(pin, std::nan("")), curves.rest_mm(pin));
  }
}

TEST(PinCurves, AnUnstablePinIsAtTheCasing) {
  const PinCurves curves(arrangement("tkD-86-20"), {});
  EXPECT_EQ(curves.rest_mm(80), 1.5);
  EXPECT_NEAR(curves.rest_mm(17), 0.516, 2e-3);
}

TEST(PinCurves, UnderAnAimedFieldTheAimedPinIsFarthestOutOfItsKind) {
  const PinCurves& curves = thesis_ball().curves;
  std::array<double, 86> forces{};
  std::array<double, 86> extensions{};
  pin_forces(thesis_ball().array, {15.0 * thesis_ball().array.pins[17].position}, fea_slope_n_a(),
             forces);
  curves.extensions_mm(forces, extensions);
  EXPECT_NEAR(extensions[17], 0.516, 2e-3);
  for (const int pin : {6, 18, 31, 47, 61})
    EXPECT_LT(extensions[static_cast<std::size_t>(pin)], extensions[17]);
  EXPECT_LT(*std::min_element(extensions.begin(), extensions.end()), -0.3);
}

RC_GTEST_PROP(PinCurves, MoreForceNeverMeansLess, ()) {
  const PinCurves& curves = thesis_ball().curves;
  const auto pin = *rc::gen::inRange<std::size_t>(0, curves.size());
  const double low = *rc::gen::inRange(-1000, 1000) * 1e-3 * kThesisForceN;
  const double more = *rc::gen::inRange(0, 1000) * 1e-4;
  RC_ASSERT(curves.offset_mm(pin, low + more) >= curves.offset_mm(pin, low));
}

}  // namespace
}  // namespace hedgehog::model
