// SPDX-License-Identifier: MIT
#include "model/magnets/ball_geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "model/geometry/goldberg.h"

namespace hedgehog::model {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double angle_between_deg(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * kDegrees;
}

const Goldberg& tkd() {
  static const Goldberg gp = canonical_goldberg(3);
  return gp;
}

// Neighbourhood of a face: sorted angles to its corners and to its neighbours.
struct View {
  std::vector<double> corners_deg;
  std::vector<double> neighbours_deg;
};

View view_of(const Goldberg& gp, const Goldberg::Face& face) {
  View view;
  for (const std::size_t i : face.corners)
    view.corners_deg.push_back(angle_between_deg(face.direction, gp.vertices[i]));
  for (const std::size_t f : face.neighbours)
    view.neighbours_deg.push_back(angle_between_deg(face.direction, gp.faces[f].direction));
  std::sort(view.corners_deg.begin(), view.corners_deg.end());
  std::sort(view.neighbours_deg.begin(), view.neighbours_deg.end());
  return view;
}

void expect_near(const std::vector<double>& got, const std::vector<double>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], expected[i], 1e-3);
}

TEST(Goldberg, TkdHas92FacesAnd180Vertices) {
  EXPECT_EQ(tkd().faces.size(), 92u);
  EXPECT_EQ(tkd().vertices.size(), 180u);
  const auto pentagons = std::count_if(tkd().faces.begin(), tkd().faces.end(),
                                       [](const auto& f) { return f.corners.size() == 5; });
  EXPECT_EQ(pentagons, 12);
}

TEST(Goldberg, EveryEdgeTouchesTheUnitSphereAndEveryFaceIsPlane) {
  const auto& v = tkd().vertices;
  for (const Goldberg::Face& face : tkd().faces) {
    const std::size_t n = face.corners.size();
    const Vec3 normal = unit_or(
        cross(v[face.corners[1]] - v[face.corners[0]], v[face.corners[2]] - v[face.corners[0]]),
        {0, 0, 0});
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3& a = v[face.corners[k]];
      const Vec3& b = v[face.corners[(k + 1) % n]];
      EXPECT_NEAR(norm(cross(a, b)) / norm(b - a), 1.0, 1e-6);
      EXPECT_NEAR(dot(normal, a - v[face.corners[0]]), 0.0, 1e-6);
    }
  }
}

// Reference: physics.md section 2, rows tkD 12, 60 and 20.
TEST(Goldberg, TkdHasTheCanonicalAngles) {
  std::map<std::string, int> classes;
  for (const Goldberg::Face& face : tkd().faces) {
    const View view = view_of(tkd(), face);
    if (face.corners.size() == 5) {
      ++classes["12"];
      expect_near(view.corners_deg, std::vector<double>(5, 10.3882));
      expect_near(view.neighbours_deg, std::vector<double>(5, 19.8178));
    } else if (view.neighbours_deg.front() < 21.0) {
      ++classes["60"];
      expect_near(view.corners_deg, {12.8868, 12.8868, 13.5125, 13.5125, 13.7472, 13.7472});
      expect_near(view.neighbours_deg, {19.8178, 22.9893, 22.9893, 23.7994, 23.9222, 23.9222});
    } else {
      ++classes["20"];
      expect_near(view.corners_deg, std::vector<double>(6, 13.9715));
      expect_near(view.neighbours_deg, std::vector<double>(6, 23.9222));
    }
  }
  EXPECT_EQ(classes, (std::map<std::string, int>{{"12", 12}, {"60", 60}, {"20", 20}}));
}

TEST(PinArray, Has86PinsInEightRings) {
  const PinArray& array = thesis_ball().array;
  ASSERT_EQ(array.pins.size(), 86u);
  ASSERT_EQ(array.rings(), 8u);
  const std::size_t sizes[] = {1, 5, 10, 15, 15, 15, 15, 10};
  for (std::size_t r = 0; r < 8; ++r) {
    ASSERT_EQ(array.ring(r).size(), sizes[r]) << r;
    for (const Pin& pin : array.ring(r)) EXPECT_EQ(pin.ring, static_cast<int>(r));
  }
  for (std::size_t i = 0; i < 86; ++i) {
    EXPECT_EQ(array.pins[i].id, static_cast<int>(i));
    EXPECT_NEAR(norm(array.pins[i].position), 1.0, 1e-12);
  }
}

TEST(PinArray, RingsGoDownAndRunAnticlockwiseFromTheFront) {
  const PinArray& array = thesis_ball().array;
  double above = 2.0;
  for (std::size_t r = 0; r < array.rings(); ++r) {
    double before = -1e-9;
    double lowest = 2.0;
    for (const Pin& pin : array.ring(r)) {
      EXPECT_LT(pin.position.z, above);
      lowest = std::min(lowest, pin.position.z);
      double azimuth = std::atan2(pin.position.y, pin.position.x) * kDegrees;
      if (azimuth < -1e-6) azimuth += 360.0;
      if (r > 0) {
        EXPECT_GT(azimuth, before) << "pin " << pin.id;
        before = azimuth;
      }
    }
    above = lowest;
  }
}

TEST(PinArray, ThePentagonIsOnTopAndTheFrontIsTheMeridianOfPin1) {
  const PinArray& array = thesis_ball().array;
  EXPECT_EQ(array.pins[0].position, (Vec3{0, 0, 1}));
  EXPECT_EQ(array.pins[1].position.y, 0.0);
  EXPECT_GT(array.pins[1].position.x, 0.0);
}

TEST(PinArray, NothingPointsDownWhereTheFanIs) {
  const PinArray& array = thesis_ball().array;
  for (const Pin& pin : array.pins) EXPECT_LT(angle_between_deg(pin.position, {0, 0, 1}), 143.0);
  const NearestPin down = nearest_pin(array, {0, 0, -1});
  EXPECT_EQ(array.pins[static_cast<std::size_t>(down.id)].ring, 7);
  EXPECT_NEAR(down.cosine, 0.79, 0.005);
}

// Pin numbers are stable; clients and studies store them.
TEST(PinArray, NumbersOfTheSixSides) {
  const PinArray& array = thesis_ball().array;
  EXPECT_EQ(nearest_pin(array, {0, 0, 1}).id, 0);
  EXPECT_EQ(nearest_pin(array, {0, 1, 0}).id, 34);
  EXPECT_EQ(nearest_pin(array, {0, -1, 0}).id, 42);
  EXPECT_EQ(nearest_pin(array, {1, 0, 0}).id, 46);
  EXPECT_EQ(nearest_pin(array, {-1, 0, 0}).id, 38);
  EXPECT_EQ(nearest_pin(array, {0, 0, -1}).id, 76);
}

TEST(PinArray, FindReturnsItsPinsOnly) {
  const PinArray& array = thesis_ball().array;
  EXPECT_EQ(array.find(-1), nullptr);
  EXPECT_EQ(array.find(86), nullptr);
  EXPECT_EQ(array.find(1LL << 40), nullptr);
  ASSERT_NE(array.find(85), nullptr);
  EXPECT_EQ(array.find(85)->id, 85);
}

RC_GTEST_PROP(PinArray, AimingAtAPinFindsItAtAnyLength, ()) {
  const PinArray& array = thesis_ball().array;
  const auto id = *rc::gen::inRange<std::size_t>(0, array.pins.size());
  const double length = std::pow(10.0, *rc::gen::inRange(-6, 7));
  const NearestPin found = nearest_pin(array, length * array.pins[id].position);
  RC_ASSERT(found.id == static_cast<int>(id));
  RC_ASSERT(std::abs(found.cosine - 1.0) < 1e-9);
}

RC_GTEST_PROP(PinArray, NoOtherPinIsNearer, (int x, int y, int z)) {
  const Vec3 expected{double(x), double(y), double(z)};
  RC_PRE(norm(expected) > 0.0);
  const PinArray& array = thesis_ball().array;
  const NearestPin found = nearest_pin(array, expected);
  for (const Pin& pin : array.pins)
    RC_ASSERT(dot(pin.position, expected) / norm(expected) <= found.cosine + 1e-6);
}

// Thesis section 3.2: 10 pins per second are about 20 cm/s.
TEST(PinPitch, IsTwoCentimetresOnTheBallOfTheThesisAndFollowsThePins) {
  EXPECT_EQ(pin_pitch_deg(thesis_ball().array), 23.5);
  const auto pitch_of = [](const char* name) {
    BallGeometry geometry;
    geometry.arrangement = name;
    geometry.sizes = {{1.0, 2.0}, {0.5, 2.0}, 60.0};
    return pin_pitch_deg(ball_pins(geometry).value()->array);
  };
  EXPECT_EQ(pitch_of("tkD"), 23.5);
  // cD's pins are 31.7 degrees from their nearest neighbour, tkD's 19.8.
  EXPECT_NEAR(pitch_of("cD"), 23.5 * 31.7175 / 19.8178, 0.01);
  EXPECT_NEAR(pitch_of("GP(4,0)"), 20.66, 0.01);
  EXPECT_EQ(pin_pitch_deg({}), kThesisPitchDeg);
}

}  // namespace
}  // namespace hedgehog::model
