// SPDX-License-Identifier: MIT
// The simulated ball as an argument of hedgehog-simboard.
#include "daemon/device/simulator/plant_text.h"

#include <gtest/gtest.h>

#include <string>

namespace hedgehog::device {
namespace {

TEST(PlantText, EveryNumberIsReadAndNothingElseIsAccepted) {
  model::PlantParameters plant;
  plant.winding_j_k = {40.1, 50.2, 60.3};
  plant.core_j_k = 70.4;
  plant.winding_to_core_k_w = {0.9, 1.1, 1.2};
  plant.core_to_ambient_fan_k_w = 1.7;
  plant.core_to_ambient_still_k_w = 4.4;
  plant.r25_ohm = {0.1, 1.0 / 3.0, 0.7};
  plant.inductance_h = 1.7e-3;
  plant.freewheel_v = 0.6;
  plant.supply_v = 24.0;
  plant.sensor_winding = 2;
  plant.sensor_lag_s = 3.3;
  plant.sensor_noise_k = 0.2;
  plant.fan_full_rpm = 5000.0;
  plant.fan_spin_up_s = 0.4;
  plant.coil_matrix = {{{0, -1, 0}, {1.02, 0, 0.1}, {0, 0, -1}}};
  plant.force_slope_n_a = 0.0131;
  const std::string text = plant_text(plant);
  const auto same = plant_from(text);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->r25_ohm, plant.r25_ohm);
  EXPECT_EQ(same->winding_j_k, plant.winding_j_k);
  EXPECT_EQ(same->sensor_winding, 2);
  EXPECT_EQ(same->fan_spin_up_s, 0.4);
  EXPECT_EQ(same->coil_matrix, plant.coil_matrix);
  EXPECT_EQ(same->force_slope_n_a, 0.0131);
  EXPECT_EQ(plant_text(*same), text);
  EXPECT_NE(plant_text({}), text);
  for (const std::string& wrong :
       {std::string(), text + ",1", text + ",", "3" + text.substr(1), "0.5" + text.substr(1),
        "x" + text, text.substr(0, text.rfind(',')), "nan" + text.substr(1),
        "2,-" + text.substr(2)})
    EXPECT_FALSE(plant_from(wrong)) << wrong;
}

}  // namespace
}  // namespace hedgehog::device
