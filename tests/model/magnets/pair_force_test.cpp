// SPDX-License-Identifier: MIT
#include "model/magnets/pair/pair_force.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "model/magnets/pair/disk_rule.h"
#include "model/magnets/pair/face_flux.h"
#include "model/units.h"
#include "tests/model/magnets/placed_magnet.h"
#include "tests/model/magnets/reference_pairs.h"

namespace hedgehog::model {
namespace {

constexpr ForceSettings kFine{ForceModel::kExact, 1e-9};

double force_n(const MagnetPair& pair, double angle, double offset, ForceModel model) {
  return pair_force(pair, angle, offset, model, 1e-8).force_n;
}

double relative(double value, double expected) { return std::abs(value / expected - 1.0); }

TEST(PairForce, ReferencePairs) {
  for (const ReferencePair& r : kReferencePairs) {
    EXPECT_LT(relative(force_n(r.pair, r.angle_deg, r.offset_mm, ForceModel::kExact), r.exact_n),
              1e-8)
        << r.angle_deg;
    EXPECT_LT(relative(force_n(r.pair, r.angle_deg, r.offset_mm, ForceModel::kDipole), r.dipole_n),
              1e-12)
        << r.angle_deg;
  }
}

// Computed at the requested, coarser accuracy.
TEST(PairForce, ReferencePairsAtAMillionthAndAThousandth) {
  for (const ReferencePair& r : kReferencePairs) {
    for (const double accuracy : {1e-3, 1e-6}) {
      const PairForce got =
          pair_force(r.pair, r.angle_deg, r.offset_mm, ForceModel::kExact, accuracy);
      EXPECT_LT(relative(got.force_n, r.exact_n), accuracy) << r.angle_deg;
      EXPECT_LE(std::abs(got.force_n - r.exact_n), got.error_n + 1e-12) << r.angle_deg;
      EXPECT_LE(got.error_n, accuracy * std::abs(got.force_n)) << r.angle_deg;
    }
  }
}

// Closed form of two coaxial cylinders (reference: physics.md section 1); distances between
// centres.
TEST(PairForce, CoaxialClosedForm) {
  const MagnetPair unequal{{8, 10}, {4, 10}, 35};
  const MagnetPair equal{{8, 10}, {8, 10}, 35};
  EXPECT_NEAR(force_n(unequal, 0, 12, ForceModel::kExact), -4.122659681, 1e-8);
  EXPECT_NEAR(force_n(unequal, 0, 15, ForceModel::kExact), -1.445583568, 1e-8);
  EXPECT_NEAR(force_n(equal, 0, 14, ForceModel::kExact), -6.475108414, 1e-8);
}

TEST(PairForce, HybridIsExactBelow30DegreesAndDipoleBeyond) {
  const MagnetPair pair;
  for (const double angle : {10.5, 20.0, 29.999}) {
    EXPECT_EQ(force_n(pair, angle, 0.5, ForceModel::kHybrid),
              force_n(pair, angle, 0.5, ForceModel::kExact));
  }
  for (const double angle : {30.0, 60.0, 180.0}) {
    EXPECT_EQ(force_n(pair, angle, 0.5, ForceModel::kHybrid),
              force_n(pair, angle, 0.5, ForceModel::kDipole));
  }
}

// Reference: physics.md section 1: the error of the dipole model.
TEST(PairForce, DipolesAreFarTooStrongNearby) {
  const auto excess = [](const MagnetPair& pair, double angle, double offset) {
    return force_n(pair, angle, offset, ForceModel::kDipole) /
           force_n(pair, angle, offset, ForceModel::kExact);
  };
  const MagnetPair pins{kThesisPinMagnet, kThesisPinMagnet, 35};
  const MagnetPair shield;
  EXPECT_NEAR(excess(pins, 31.7, 0.0), 1.11, 0.01);
  EXPECT_NEAR(excess(pins, 19.8, 0.0), 1.34, 0.01);
  EXPECT_NEAR(excess(shield, 12.0, 0.0), 1.73, 0.01);
  EXPECT_NEAR(excess(shield, 12.0, 0.5), 2.45, 0.05);
}

TEST(PairForce, NamesOfTheModels) {
  for (const ForceModel model : {ForceModel::kExact, ForceModel::kHybrid, ForceModel::kDipole})
    EXPECT_EQ(force_model_named(name_of(model)), model);
  EXPECT_EQ(force_model_named("fea"), std::nullopt);
}

// On a 35 mm sphere the pin's inner edge touches the shield's mantle at about 9.8 degrees.
TEST(PairForce, GapOfThesisMagnets) {
  const MagnetPair pair;
  const double contact =
      (std::asin(2.0 / std::hypot(35.0, 4.0)) + std::atan(4.0 / 35.0)) / kRadiansPerDegree;
  EXPECT_NEAR(contact, 9.78, 0.01);
  EXPECT_NEAR(gap_mm(pair, {contact, 0.0, 0.0}), 0.0, 1e-9);
  EXPECT_GT(gap_mm(pair, {contact + 0.1, 0.0, 0.0}), 0.05);
  EXPECT_LT(gap_mm(pair, {contact - 0.1, 0.0, 0.0}), -0.05);
  // Coaxial with a gap of 2 mm; and on opposite sides of the sphere.
  EXPECT_NEAR(gap_mm(pair, {0.0, 12.0, 0.0}), 2.0, 1e-9);
  EXPECT_NEAR(gap_mm(pair, {180.0, 0.0, 0.0}), 70.0, 1e-9);
}

TEST(CylinderMagnet, OnItsAxis) {
  const CylinderMagnet magnet{8, 10};
  for (const double z : {5.5, 8.0, 20.0, 100.0}) {
    const auto end = [&](double distance) { return distance / std::hypot(distance, 4.0); };
    EXPECT_NEAR(field_of(magnet, 0.0, z).axial_t, 0.5 * 1.37 * (end(z + 5.0) - end(z - 5.0)),
                1e-12);
    EXPECT_NEAR(field_of(magnet, 0.0, z).radial_t, 0.0, 1e-15);
  }
}

// Its field is that of the charges on its two faces: a plain sum of points, without elliptic
// integrals.
TEST(CylinderMagnet, IsTwoChargedFaces) {
  const CylinderMagnet magnet{8, 10};
  for (const Vec3 point : {Vec3{7, 0, 1}, Vec3{3, 0, 9}, Vec3{4, 0, -12}, Vec3{20, 0, 30}}) {
    Vec3 sum;
    constexpr int kRings = 300;
    constexpr int kAround = 300;
    for (const double face : {1.0, -1.0}) {
      for (int i = 0; i < kRings; ++i) {
        for (int j = 0; j < kAround; ++j) {
          const double rho = 4.0 * std::sqrt((i + 0.5) / kRings);
          const double phi = 2.0 * std::numbers::pi * (j + 0.5) / kAround;
          const Vec3 r = point - Vec3{rho * std::cos(phi), rho * std::sin(phi), 5.0 * face};
          sum = sum + (face / std::pow(norm(r), 3)) * r;
        }
      }
    }
    const Vec3 field = (1.37 * 16.0 / 4.0 / (kRings * kAround)) * sum;
    const AxialField got = field_of(magnet, point.x, point.z);
    EXPECT_NEAR(got.radial_t, field.x, 2e-6);
    EXPECT_NEAR(got.axial_t, field.z, 2e-6);
  }
}

TEST(CylinderMagnet, FieldIsFiniteOnTheMantlesRadius) {
  const CylinderMagnet magnet{8, 10};
  const AxialField at = field_of(magnet, 4.0, 9.0);
  EXPECT_NEAR(at.axial_t, field_of(magnet, 4.0 + 1e-7, 9.0).axial_t, 1e-6);
  EXPECT_NEAR(at.axial_t, field_of(magnet, 4.0 - 1e-7, 9.0).axial_t, 1e-6);
}

TEST(CylinderMagnet, MassOfTheThesisMagnets) {
  EXPECT_NEAR(86 * mass_g(kThesisPinMagnet), 320.0, 5.0);
  EXPECT_NEAR(170 * mass_g(kThesisShieldMagnet), 160.0, 1.0);
}

TEST(CylinderMagnet, BadSizesHaveASentence) {
  EXPECT_EQ(problem_with(kThesisPinMagnet, "the pin"), std::nullopt);
  EXPECT_EQ(problem_with({-8, 10}, "the pin").value(),
            "the pin: the diameter must be above 0 and at most 1 m");
  EXPECT_TRUE(problem_with({8, 0}, "the pin"));
  EXPECT_TRUE(problem_with({8, 10, 3.0}, "the pin"));
  EXPECT_TRUE(problem_with({std::nan(""), 10}, "the pin"));
}

// --- laws ---------------------------------------------------------------------------------------

double any_between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 10'001) / 10'000.0;
}

CylinderMagnet any_magnet() {
  return {any_between(2, 12), any_between(2, 15), any_between(0.5, 1.45)};
}

struct PairOnSphere {
  MagnetPair pair;
  PairPlace place;
};

/// Gap of at least 0.1 mm.
PairOnSphere any_pair() {
  const PairOnSphere any{{any_magnet(), any_magnet(), any_between(15, 60)},
                         {any_between(3, *rc::gen::element(40, 180)), any_between(-2.5, 12.5),
                          *rc::gen::element(0.0, any_between(-1, 2))}};
  RC_PRE(gap_mm(any.pair, any.place) >= 0.1);
  return any;
}

PlacedMagnet subject_of(const PairOnSphere& p) {
  const double angle = p.place.angle_deg * kRadiansPerDegree;
  const Vec3 axis{std::sin(angle), 0.0, std::cos(angle)};
  const double middle =
      p.pair.sphere_radius_mm + p.place.offset_mm + 0.5 * p.pair.subject.height_mm;
  return {p.pair.subject, middle * axis, axis};
}

PlacedMagnet other_of(const PairOnSphere& p) {
  const double middle =
      p.pair.sphere_radius_mm + p.place.other_offset_mm + 0.5 * p.pair.other.height_mm;
  return {p.pair.other, {0.0, 0.0, middle}, {0, 0, 1}};
}

// An independent computation of the same force: whole disks, another order, no mirror plane.
RC_GTEST_PROP(PairForceLaw, TheRequestedAccuracyIsMetAndTheErrorIsABound, ()) {
  const PairOnSphere p = any_pair();
  const double accuracy = std::pow(10.0, -any_between(2, 8));
  const PairForce got = pair_force(p.pair, p.place, {ForceModel::kExact, accuracy});
  const PlacedMagnet subject = subject_of(p);
  const double fine_n = dot(force_between(subject, other_of(p), DiskRule::kMaxOrder), subject.axis);
  const double bottom_mm = p.pair.sphere_radius_mm + p.place.offset_mm;
  const FaceFlux flux(p.pair, p.place.angle_deg, p.place.other_offset_mm);
  const double face_n =
      std::max(std::abs(flux.first(bottom_mm, 0.1).force_n),
               std::abs(flux.first(bottom_mm + p.pair.subject.height_mm, 0.1).force_n));
  const double error = std::abs(got.force_n - fine_n);
  RC_ASSERT(error <= accuracy * std::max(std::abs(fine_n), 1.1e-4 * face_n) + 1e-12 * face_n);
  RC_ASSERT(error <= got.error_n + 1e-12 * face_n);
}

RC_GTEST_PROP(PairForceLaw, ActionIsReactionAsVectors, ()) {
  const PairOnSphere p = any_pair();
  RC_PRE(gap_mm(p.pair, p.place) >= 1.0);
  const Vec3 on_subject = force_between(subject_of(p), other_of(p), 24);
  const Vec3 on_other = force_between(other_of(p), subject_of(p), 24);
  RC_ASSERT(norm(on_subject + on_other) <= 1e-6 * norm(on_subject) + 1e-12);
}

RC_GTEST_PROP(PairForceLaw, TurnsAndMirrorsWithThePair, ()) {
  const PairOnSphere p = any_pair();
  const PlacedMagnet a = subject_of(p);
  const PlacedMagnet b = other_of(p);
  const Vec3 axis =
      unit_or({any_between(-1, 1), any_between(-1, 1), any_between(-1, 1)}, {0, 0, 1});
  const double turn = any_between(0.0, 6.28);
  const auto turned = [&](const Vec3& v) {
    return std::cos(turn) * v + std::sin(turn) * cross(axis, v) +
           (1.0 - std::cos(turn)) * dot(axis, v) * axis;
  };
  const auto mirrored = [&](const Vec3& v) { return v - 2.0 * dot(axis, v) * axis; };
  const auto moved = [](const PlacedMagnet& m, const auto& map) {
    return PlacedMagnet{m.magnet, map(m.centre_mm), map(m.axis)};
  };
  // The rule's own orientation is not rotated with the pair: the difference is its error.
  const Vec3 force = force_between(a, b, DiskRule::kMaxOrder);
  const double scale = 1e-6 * norm(force) + 1e-12;
  const Vec3 after_turn = force_between(moved(a, turned), moved(b, turned), DiskRule::kMaxOrder);
  RC_ASSERT(norm(after_turn - turned(force)) <= scale);
  const Vec3 in_mirror = force_between(moved(a, mirrored), moved(b, mirrored), DiskRule::kMaxOrder);
  RC_ASSERT(norm(in_mirror - mirrored(force)) <= scale);
}

RC_GTEST_PROP(PairForceLaw, OppositePolarityTurnsTheForceAround, ()) {
  const PairOnSphere p = any_pair();
  const PlacedMagnet a = subject_of(p);
  PlacedMagnet b = other_of(p);
  const Vec3 force = force_between(a, b, 8);
  b.axis = -b.axis;
  RC_ASSERT(norm(force_between(a, b, 8) + force) <= 1e-9 * norm(force));
}

RC_GTEST_PROP(PairForceLaw, GrowsWithBothRemanences, ()) {
  PairOnSphere p = any_pair();
  const double before = pair_force(p.pair, p.place, kFine).force_n;
  p.pair.subject.remanence_t *= 0.5;
  p.pair.other.remanence_t *= 0.25;
  RC_ASSERT(std::abs(pair_force(p.pair, p.place, kFine).force_n - before / 8.0) <=
            1e-8 * std::abs(before) + 1e-15);
}

// The non-dipole part falls with the square of the distance.
RC_GTEST_PROP(PairForceLaw, FarPairsTendToDipoles, ()) {
  const MagnetPair near{any_magnet(), any_magnet(), 200.0};
  const double angle = any_between(30, 180);
  const auto excess = [&](double sphere_mm) {
    MagnetPair pair = near;
    pair.sphere_radius_mm = sphere_mm;
    const double dipole_n = force_n(pair, angle, 0.0, ForceModel::kDipole);
    return std::abs(force_n(pair, angle, 0.0, ForceModel::kExact) / dipole_n - 1.0);
  };
  RC_ASSERT(excess(200.0) < 0.05);
  RC_ASSERT(excess(800.0) < 0.05 / 14.0);
}

RC_GTEST_PROP(PairForceLaw, TheOtherSideOfTheAngleIsTheSame, ()) {
  const PairOnSphere p = any_pair();
  PairPlace mirrored = p.place;
  mirrored.angle_deg = 360.0 - mirrored.angle_deg;
  const double force = pair_force(p.pair, p.place, kFine).force_n;
  RC_ASSERT(std::abs(pair_force(p.pair, mirrored, kFine).force_n - force) <=
            1e-8 * std::abs(force) + 1e-12);
}

}  // namespace
}  // namespace hedgehog::model
