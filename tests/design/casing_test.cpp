// SPDX-License-Identifier: MIT
// The casing: its dimensions, and the check that a surface is closed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "clients/design/casing/casing.h"
#include "clients/design/casing/stl.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {
namespace {

std::string facet(const char* a, const char* b, const char* c) {
  return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b +
         "\nvertex " + c + "\nendloop\nendfacet\n";
}

TEST(Stl, ATetrahedronIsClosedAndEnclosesASixth) {
  const char* o = "0 0 0";
  const char* x = "1 0 0";
  const char* y = "0 1 0";
  const char* z = "0 0 1";
  const std::string sides = facet(o, y, x) + facet(o, z, y) + facet(o, x, z);
  const auto closed = check_stl("solid t\n" + sides + facet(x, y, z) + "endsolid t\n").value();
  EXPECT_EQ(closed.triangles, 4U);
  EXPECT_EQ(closed.open_edges, 0U);
  EXPECT_NEAR(closed.volume_mm3, 1.0 / 6.0, 1e-12);
  EXPECT_EQ(check_stl("solid t\n" + sides).value().open_edges, 3U);
  EXPECT_EQ(check_stl("solid t\n" + sides + facet(x, z, y)).value().open_edges, 3U)
      << "one looks inwards";
  EXPECT_EQ(check_stl("solid t\n" + sides + facet(x, y, z) + facet(x, y, z)).value().open_edges, 3U)
      << "one is double";
  EXPECT_FALSE(check_stl("not one").has_value());
  EXPECT_FALSE(check_stl("solid t\nvertex 0 0").has_value());
}

TEST(Casing, HasTheOuterDiameterOfTheThesis) {
  EXPECT_DOUBLE_EQ(outer_radius_mm(35, {8, 10}, {4, 10}), 50.0);
  EXPECT_DOUBLE_EQ(outer_radius_mm(35, {8, 10}, {4, 15}), 53.5);
}

TEST(Casing, TabsKeepAwayFromPinsAndFitOneWayOnly) {
  Casing casing;
  casing.pin = {8, 10};
  casing.shield = {4, 10};
  const auto array = find_arrangement("tkD-86").value();
  for (const auto& pin : array.pins) casing.pins.push_back(pin.direction);
  for (const auto& shield : array.shields) casing.shields.push_back(shield.direction);
  const auto places = notch_places(casing);
  ASSERT_EQ(places.size(), 3U);
  const double first = places[1] - places[0];
  const double second = places[2] - places[1];
  const double third = 360.0 - first - second;
  EXPECT_GT(std::min({std::abs(first - second), std::abs(second - third), std::abs(third - first)}),
            1.0);
  for (const double place : places) {
    const double turn = place * std::numbers::pi / 180.0;
    const model::Vec3 tab{48.25 * std::cos(turn), 48.25 * std::sin(turn), 1.5};
    for (const auto& pin : casing.pins) {
      const double away = model::norm(tab - model::dot(tab, pin) * pin);
      EXPECT_TRUE(model::dot(tab, pin) < 0 || away > 0.3 * 8.0 + 2.6) << place;
    }
  }
  const double fan_mm = widest_fan_mm(casing);
  EXPECT_GT(fan_mm, 15.0);
  casing.fan_mm = fan_mm;
  casing.pins.push_back({0, 0, -1});
  EXPECT_EQ(widest_fan_mm(casing), 0.0) << "a pin at the bottom leaves no room";
}

}  // namespace
}  // namespace hedgehog::design
