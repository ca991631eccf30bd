// SPDX-License-Identifier: MIT
#include "model/magnets/arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/geometry/goldberg.h"
#include "model/magnets/ball_geometry.h"
#include "model/magnets/magnet_array.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::model {
namespace {

using testing::HasSubstr;

Arrangement named(std::string_view name) { return arrangement_named(name).value(); }

std::vector<std::size_t> sizes_of(const std::vector<PinClass>& classes) {
  std::vector<std::size_t> sizes;
  sizes.reserve(classes.size());
  for (const PinClass& c : classes) sizes.push_back(c.pins.size());
  return sizes;
}

TEST(Goldberg, AllThatFitTheLimitAreGoldbergPolyhedra) {
  for (const auto& [m, n] : {std::pair{1, 0}, {1, 1}, {2, 1}, {1, 2}, {2, 2}, {3, 1}, {4, 1}}) {
    const Goldberg gp = canonical_goldberg(m, n);
    const int steps = m * m + m * n + n * n;
    const auto t = static_cast<std::size_t>(steps);
    EXPECT_EQ(gp.faces.size(), 10 * t + 2);
    EXPECT_EQ(gp.vertices.size(), 20 * t);
    std::size_t pentagons = 0;
    for (const Goldberg::Face& face : gp.faces) {
      ASSERT_TRUE(face.corners.size() == 5 || face.corners.size() == 6);
      ASSERT_EQ(face.neighbours.size(), face.corners.size());
      if (face.corners.size() == 5) ++pentagons;
      for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const Vec3& a = gp.vertices[face.corners[k]];
        const Vec3& b = gp.vertices[face.corners[(k + 1) % face.corners.size()]];
        ASSERT_NEAR(norm(cross(a, b)) / norm(b - a), 1.0, 1e-6);
        ASSERT_GT(dot(cross(a, b), face.direction), 0.0);
      }
    }
    EXPECT_EQ(pentagons, 12u);
  }
}

TEST(Goldberg, APentagonIsOnTopAndItsNearestPentagonInFront) {
  for (const auto& [m, n] : {std::pair{2, 0}, {2, 1}, {3, 1}}) {
    const Goldberg gp = canonical_goldberg(m, n);
    int front = 0;
    for (const Goldberg::Face& face : gp.faces) {
      if (face.corners.size() != 5) continue;
      if (face.direction.z > 1.0 - 1e-9) front += 10;
      // The icosahedron's other corners are at a height of 1/sqrt(5).
      if (std::abs(face.direction.z - 1.0 / std::sqrt(5.0)) < 1e-6 && face.direction.x > 0.0 &&
          std::abs(face.direction.y) < 1e-6)
        ++front;
    }
    EXPECT_EQ(front, 11) << m << ' ' << n;
  }
}

struct Near {
  double angle_deg;
  int count;
};

struct ClassAngles {
  const char* array;
  std::size_t size;
  std::vector<Near> shields;
  std::vector<Near> pins;
};

// Reference: physics.md section 2, the canonical angles.
TEST(SymmetryClasses, CanonicalAngles) {
  const std::vector<ClassAngles> expected{
      {"cD", 12, {{16.7896, 5}}, {{31.7175, 5}}},
      {"cD", 30, {{20.4056, 4}, {20.9052, 2}}, {{31.7175, 2}, {36.0, 4}}},
      {"wD", 12, {{12.0875, 5}}, {{22.9809, 5}}},
      {"wD",
       60,
       {{14.9022, 2}, {15.5233, 2}, {15.7565, 2}},
       {{22.9809, 1}, {26.5336, 2}, {27.0692, 1}, {27.2031, 2}}},
      {"tkD", 12, {{10.3882, 5}}, {{19.8178, 5}}},
      {"tkD",
       60,
       {{12.8868, 2}, {13.5125, 2}, {13.7472, 2}},
       {{19.8178, 1}, {22.9893, 2}, {23.7994, 1}, {23.9222, 2}}},
      {"tkD", 20, {{13.9715, 6}}, {{23.9222, 6}}},
  };
  for (const ClassAngles& w : expected) {
    const auto classes = symmetry_classes(named(w.array));
    const auto found = std::find_if(classes.begin(), classes.end(),
                                    [&](const PinClass& c) { return c.pins.size() == w.size; });
    ASSERT_NE(found, classes.end()) << w.array << w.size;
    const auto expect = [&](const std::vector<AngleCount>& got, const std::vector<Near>& nearest) {
      for (std::size_t i = 0; i < nearest.size(); ++i) {
        EXPECT_NEAR(got[i].angle_deg, nearest[i].angle_deg, 1e-3) << w.array << w.size;
        EXPECT_EQ(got[i].count, nearest[i].count) << w.array << w.size;
      }
    };
    expect(found->to_shields, w.shields);
    expect(found->to_pins, w.pins);
  }
}

TEST(SymmetryClasses, AreDetected) {
  EXPECT_EQ(sizes_of(symmetry_classes(named("GP(1,0)"))), (std::vector<std::size_t>{12}));
  EXPECT_EQ(sizes_of(symmetry_classes(named("GP(1,1)"))), (std::vector<std::size_t>{12, 20}));
  EXPECT_EQ(sizes_of(symmetry_classes(named("cD"))), (std::vector<std::size_t>{12, 30}));
  EXPECT_EQ(sizes_of(symmetry_classes(named("wD"))), (std::vector<std::size_t>{12, 60}));
  EXPECT_EQ(sizes_of(symmetry_classes(named("tkD"))), (std::vector<std::size_t>{12, 60, 20}));
}

TEST(SymmetryClasses, ListTheirPinsInOrderForAnyArrangement) {
  Arrangement turned = named("wD");
  std::reverse(turned.pins.begin(), turned.pins.end());
  std::reverse(turned.shields.begin(), turned.shields.end());
  const auto ids = [](const std::vector<PinClass>& classes) {
    std::vector<std::vector<int>> each;
    each.reserve(classes.size());
    for (const PinClass& one : classes) each.push_back(one.pins);
    return each;
  };
  EXPECT_EQ(ids(symmetry_classes(turned)), ids(symmetry_classes(named("wD"))));
}

TEST(SymmetryClasses, TheBallKeepsItsFivefoldAxisOnly) {
  const Arrangement ball = named("tkD-86");
  std::set<int> pins;
  int all = 0;
  for (const PinClass& c : symmetry_classes(ball)) {
    EXPECT_TRUE(c.pins.size() == 1 || c.pins.size() == 5 || c.pins.size() == 10);
    pins.insert(c.pins.begin(), c.pins.end());
    all += static_cast<int>(c.pins.size());
    int others = 0;
    for (const AngleCount& angle : c.to_pins) others += angle.count;
    EXPECT_EQ(others, 85);
    int shields = 0;
    for (const AngleCount& angle : c.to_shields) shields += angle.count;
    EXPECT_EQ(shields, 170);
  }
  EXPECT_EQ(all, 86);
  EXPECT_EQ(pins.size(), 86u);
}

TEST(Arrangement, CountsOfTheNamedOnes) {
  struct Count {
    const char* name;
    std::size_t pins;
    std::size_t shields;
  };
  for (const Count& c : {Count{"cD", 42, 80}, Count{"wD", 72, 140}, Count{"tkD", 92, 180},
                         Count{"GP(4,1)", 212, 420}, Count{"tkD-86", 86, 170},
                         Count{"tkD-86-5", 86, 175}, Count{"tkD-86-20", 86, 160}}) {
    const Arrangement a = named(c.name);
    EXPECT_EQ(a.name, c.name);
    EXPECT_EQ(a.pins.size(), c.pins);
    EXPECT_EQ(a.shields.size(), c.shields);
    for (const MagnetSite& site : a.pins) EXPECT_NEAR(norm(site.direction), 1.0, 1e-12);
    for (const MagnetSite& site : a.shields) EXPECT_NEAR(norm(site.direction), 1.0, 1e-12);
  }
}

TEST(Arrangement, PinsOfTheBallHaveTheirNumbers) {
  for (const char* name : {"tkD", "tkD-86", "tkD-86-5", "tkD-86-20"}) {
    const Arrangement ball = named(name);
    for (const Pin& pin : thesis_ball().array.pins) {
      const MagnetSite& site = ball.pins[static_cast<std::size_t>(pin.id)];
      EXPECT_EQ(site.id, pin.id);
      EXPECT_LT(norm(site.direction - pin.position), 1e-6) << name << pin.id;
    }
  }
}

TEST(Arrangement, UnknownNamesHaveASentence) {
  for (const char* name : {"", "tkd", "d", "GP(", "GP()", "GP(3)", "GP(3,)", "GP(3,0", "GP(3,0) ",
                           "GP(a,b)", "tkD-85"}) {
    const auto result = arrangement_named(name);
    ASSERT_TRUE(result.has_error()) << name;
    EXPECT_THAT(result.error().message, HasSubstr("unknown array"));
  }
  for (const char* name :
       {"GP(0,0)", "GP(0,3)", "GP(-1,2)", "GP(8,1)", "GP(2000000000,2000000000)"}) {
    const auto result = arrangement_named(name);
    ASSERT_TRUE(result.has_error()) << name;
    EXPECT_THAT(result.error().message, HasSubstr("at most 8"));
  }
}

TEST(Arrangement, RemovedSitesDoNotRenumberTheOthers) {
  const std::vector<int> pins{3, 5};
  const std::vector<int> shields{0};
  const Arrangement rest = without(named("cD"), pins, shields).value();
  EXPECT_EQ(rest.pins.size(), 40u);
  EXPECT_EQ(rest.pins[3].id, 4);
  EXPECT_EQ(rest.shields.size(), 79u);
  const auto missing = without(rest, std::vector<int>{5}, {});
  ASSERT_TRUE(missing.has_error());
  EXPECT_EQ(missing.error().message, "there is no pin 5 to remove");
  EXPECT_TRUE(without(rest, {}, std::vector<int>{80}).has_error());
}

TEST(MagnetArray, TheThesisArraysFitAndTheNextDenserDoesNot) {
  for (const char* name : {"cD", "wD", "tkD", "tkD-86"})
    EXPECT_FALSE(check_fit(named(name), {})) << name;
  const auto error = check_fit(named("GP(2,2)"), {});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->message, "pin 0 and shield 0 overlap by 0.63 mm at 8.76 degrees");
}

TEST(MagnetArray, GapsOfTkd) {
  const auto gaps = smallest_gaps(named("tkD"), {});
  ASSERT_EQ(gaps.size(), 3u);
  EXPECT_NEAR(gaps[0].angle_deg, 19.8178, 1e-3);
  EXPECT_NEAR(gaps[1].angle_deg, 10.3882, 1e-3);
  EXPECT_EQ(gaps[1].kind_a, MagnetKind::kPin);
  EXPECT_EQ(gaps[1].kind_b, MagnetKind::kShield);
  // Computed by hand: distance of the pin's inner edge from the shield's side.
  const double angle = 10.3882 * 3.14159265358979 / 180.0;
  EXPECT_NEAR(gaps[1].gap_mm, 35.0 * std::sin(angle) - 4.0 * std::cos(angle) - 2.0, 0.01);
}

TEST(MagnetArray, BadSizesHaveASentence) {
  ArraySizes sizes;
  sizes.shield.diameter_mm = -4.0;
  EXPECT_EQ(check_fit(named("cD"), sizes)->message,
            "the shield: the diameter must be above 0 and at most 1 m");
  sizes = {};
  sizes.sphere_radius_mm = std::nan("");
  EXPECT_EQ(check_fit(named("cD"), sizes)->message,
            "the radius of the sphere must be above 0 and at most 1 m");
}

TEST(MagnetArray, HasTheMassOfItsMagnets) {
  EXPECT_NEAR(magnets_mass_g(named("tkD-86"), {}), 484.4, 0.1);
}

}  // namespace
}  // namespace hedgehog::model
