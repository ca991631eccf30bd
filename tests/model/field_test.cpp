// SPDX-License-Identifier: MIT
#include "model/geometry/field.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "model/calibration.h"
#include "model/magnets/ball_geometry.h"
#include "model/magnets/electromagnet.h"

namespace hedgehog::model {
namespace {

constexpr double kSlope = kMeasuredCalibration.force_slope_n_a;
constexpr double kFelt = 0.03;

// One of the 60 hexagons beside a pentagon, far enough from the hole at the bottom.
constexpr std::size_t kHexagon = 17;

FieldDemand aimed_at(std::size_t pin, double current_a) {
  return {current_a * thesis_ball().array.pins[pin].position};
}

// Reference: physics.md section 5.
TEST(Field, ForcePerMomentOfTheThesisPin) {
  EXPECT_NEAR(force_per_moment(kThesisPin), 0.131836, 1e-6);
  EXPECT_LT(force_per_moment(kThesisPin, 1e-3), force_per_moment(kThesisPin));
}

// The law itself against a brute-force sum over the poles of the rod's two faces: the charge of a
// ring of the face in the dipole's potential gradient.
TEST(Field, ForcePerMomentAndCosineAgreeWithAQuadratureOverTheFaces) {
  const double mu0_4pi = 1e-7;
  const double charge = kThesisPin.remanence_t / (4e-7 * std::numbers::pi);  // A/m
  for (const double tilt : {0.0, 0.3, 1.0, std::numbers::pi / 2, 2.5}) {
    const Vec3 moment{std::sin(tilt), 0.0, std::cos(tilt)};
    double force = 0.0;
    for (const double sign : {-1.0, 1.0}) {
      const double z = kThesisPin.inner_face_m + (sign > 0 ? kThesisPin.length_m : 0.0);
      constexpr int kRadial = 200;
      constexpr int kAround = 64;
      for (int i = 0; i < kRadial; ++i) {
        const double rho = kThesisPin.radius_m * std::sqrt((i + 0.5) / kRadial);
        for (int j = 0; j < kAround; ++j) {
          const double phi = 2.0 * std::numbers::pi * j / kAround;
          const Vec3 r{rho * std::cos(phi), rho * std::sin(phi), z};
          const double d = norm(r);
          const double field_z =
              mu0_4pi * (3.0 * dot(moment, r) * r.z / std::pow(d, 5) - moment.z / std::pow(d, 3));
          const double area =
              std::numbers::pi * kThesisPin.radius_m * kThesisPin.radius_m / (kRadial * kAround);
          force += sign * charge * field_z * area;
        }
      }
    }
    // The rod's near face carries the pole that the dipole's near end repels.
    EXPECT_NEAR(-force, force_per_moment(kThesisPin) * std::cos(tilt), 1e-6) << tilt;
  }
}

TEST(Field, BothCalibrationsFollowFromTheLaw) {
  EXPECT_NEAR(fea_electromagnet().moment_per_ampere * force_per_moment(kThesisPin),
              kFeaCalibration.force_slope_n_a, 1e-5);
  const double rest_m = 1e-3 * thesis_ball().curves.typical_rest_mm();
  EXPECT_NEAR(measured_electromagnet().moment_per_ampere * force_per_moment(kThesisPin, rest_m),
              kMeasuredCalibration.force_slope_n_a, 1e-9);
  EXPECT_NEAR(15.0 * kFeaCalibration.force_slope_n_a, 0.4, 1e-3);
}

TEST(Field, TheAimedPinGets63MillinewtonAt5AmpereAnd189At15) {
  const Vec3& pin = thesis_ball().array.pins[kHexagon].position;
  EXPECT_NEAR(force_on_pin(aimed_at(kHexagon, 5.0), pin, kSlope), 0.063, 1e-9);
  EXPECT_NEAR(force_on_pin(aimed_at(kHexagon, 15.0), pin, kSlope), 0.189, 1e-9);
}

// Reference: physics.md section 5, aiming at a hexagon beside a pentagon.
TEST(Field, FractionsAroundTheAimedPin) {
  std::array<double, 86> forces{};
  pin_forces(thesis_ball().array, aimed_at(kHexagon, 1.0), 1.0, forces);
  std::sort(forces.rbegin(), forces.rend());
  const double expected[] = {1.0, 0.941, 0.921, 0.921, 0.915, 0.914, 0.914, 0.792};
  for (std::size_t i = 0; i < std::size(expected); ++i)
    EXPECT_NEAR(forces[i], expected[i], 6e-4) << i;
}

/// Spatial spread of a felt field: never one pin, always an area (thesis section 3.1.3).
struct FieldSpread {
  /// Pins with at least 90 % and 50 % of the force on a pin exactly in the field's direction.
  int pins_90 = 0;
  int pins_50 = 0;
  /// Pins that are pulled in.
  int pins_inward = 0;
  /// Pins whose outward force exceeds `threshold_n`.
  int pins_above = 0;
};

/// `threshold_n`: threshold of perception, 0.03 N in thesis section 3.1.3. A zero field has no
/// spread.
FieldSpread spread_of(const PinArray& array, const FieldDemand& field, double slope_n_a,
                      double threshold_n) noexcept {
  FieldSpread spread;
  const double full_n = slope_n_a * norm(field.a);
  if (!(full_n > 0.0)) return spread;
  for (const Pin& pin : array.pins) {
    const double force_n = force_on_pin(field, pin.position, slope_n_a);
    if (force_n >= 0.9 * full_n) ++spread.pins_90;
    if (force_n >= 0.5 * full_n) ++spread.pins_50;
    if (force_n < 0.0) ++spread.pins_inward;
    if (force_n > threshold_n) ++spread.pins_above;
  }
  return spread;
}

TEST(Field, SpreadOf86Pins) {
  const FieldSpread at_5 = spread_of(thesis_ball().array, aimed_at(kHexagon, 5.0), kSlope, kFelt);
  EXPECT_EQ(at_5.pins_90, 7);
  EXPECT_EQ(at_5.pins_50, 21);
  EXPECT_EQ(at_5.pins_inward, 40);
  EXPECT_EQ(at_5.pins_above, 25);
  EXPECT_EQ(spread_of(thesis_ball().array, aimed_at(kHexagon, 15.0), kSlope, kFelt).pins_above, 39);
}

TEST(Field, NoFieldPushesNothing) {
  const FieldSpread none = spread_of(thesis_ball().array, {}, kSlope, kFelt);
  EXPECT_EQ(none.pins_90 + none.pins_50 + none.pins_inward + none.pins_above, 0);
}

RC_GTEST_PROP(Field, TheOppositePinIsPulledAsMuch, (int x, int y, int z)) {
  const FieldDemand field{{x * 1e-3, y * 1e-3, z * 1e-3}};
  const Vec3 pin = thesis_ball().array.pins[*rc::gen::inRange<std::size_t>(0, 86)].position;
  const double out = force_on_pin(field, pin, kSlope);
  RC_ASSERT(force_on_pin(field, -pin, kSlope) == -out);
  RC_ASSERT(std::abs(out) <= kSlope * norm(field.a) * (1.0 + 1e-12));
}

}  // namespace
}  // namespace hedgehog::model
