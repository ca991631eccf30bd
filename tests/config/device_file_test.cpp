// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "daemon/config/keys/device_keys.h"
#include "daemon/config/keys/limit_keys.h"
#include "tests/config/fake_files.h"

namespace hedgehog::config {
namespace {

TEST(DeviceFile, EveryKeyIsLoaded) {
  const FakeFiles fake = FakeFiles::with_device(R"({
    "name": "ball-7", "model": "hedgehog-86b", "arrangement": "tkD-86", "front_pin": 1,
    "coil_matrix": [[0, 1, 0], [-1.02, 0, 0.01], [0, 0, 0.98]], "r25_ohm": [0.612, 0.598, 0.641],
    "inductance_h": 0.002, "supply_v": 15, "force_slope_n_a": 0.0127,
    "thermal": {"winding_j_k": 60, "core_j_k": 90, "winding_to_core_k_w": [1.1, 1, 0.9],
                "core_to_room_fan_k_w": 1.9, "core_to_room_still_k_w": 5.5, "sensor_winding": 2,
                "sensor_lag_s": 1.5, "fan_rpm": 4500},
    "uncertainty": {"thermal": 0.06, "resistance": 0.01, "thermistor_k": 1},
    "limits": {"current_a": 12, "continuous_a": 4, "felt_a": 2, "derate_from_c": 55,
               "sustain_c": 60, "zero_c": 62, "trip_c": 64, "rearm_c": 40},
    "usb": ["1209:0001", "CAFE:4011"]})");
  ASSERT_EQ(fake.errors(), "");
  const model::DeviceModel d = fake.load()->device;
  EXPECT_EQ(d.name, "ball-7");
  EXPECT_EQ(d.model, "hedgehog-86b");
  EXPECT_EQ(d.coils.matrix, (model::Mat3{{{0, 1, 0}, {-1.02, 0, 0.01}, {0, 0, 0.98}}}));
  EXPECT_EQ(d.coils.r25_ohm, (std::array<double, 3>{0.612, 0.598, 0.641}));
  EXPECT_EQ(d.coils.inductance_h, 0.002);
  EXPECT_EQ(d.coils.supply_v, 15);
  EXPECT_EQ(d.force_slope_n_a, 0.0127);
  EXPECT_EQ(d.thermal.winding_j_k, (std::array<double, 3>{60, 60, 60}));
  EXPECT_EQ(d.thermal.core_j_k, 90);
  EXPECT_EQ(d.thermal.winding_to_core_k_w, (std::array<double, 3>{1.1, 1, 0.9}));
  EXPECT_EQ(d.thermal.core_to_ambient_fan_k_w, 1.9);
  EXPECT_EQ(d.thermal.core_to_ambient_still_k_w, 5.5);
  EXPECT_EQ(d.thermal.sensor_winding, 2);
  EXPECT_EQ(d.thermal.sensor_lag_s, 1.5);
  EXPECT_EQ(d.thermal.fan_full_rpm, 4500);
  EXPECT_EQ(d.uncertainty, (model::ThermalUncertainty{0.06, 0.01, 1}));
  EXPECT_EQ(d.limits, (model::Limits{12, 4, 2, 55, 60, 62, 64, 40}));
  EXPECT_EQ(d.usb, (std::vector<model::UsbId>{{0x1209, 1}, {0xcafe, 0x4011}}));
  // Without tighter limits in the configuration, the ball's own apply.
  EXPECT_EQ(fake.load()->limits, d.limits);

  FakeFiles again = FakeFiles::with_device(print_device(d));
  ASSERT_EQ(again.errors(), "");
  EXPECT_EQ(print_device(again.load()->device), print_device(d));
}

TEST(DeviceFile, AnyGeometryIsData) {
  const FakeFiles fake = FakeFiles::with_device(R"json({
    "arrangement": "GP(4,1)", "removed_pins": [211, 7], "removed_shields": [0], "front_pin": 3,
    "pin_magnet_mm": [4, 6], "shield_magnet_mm": [2, 6], "remanence_t": 1.2, "sphere_mm": 50})json");
  ASSERT_EQ(fake.errors(), "");
  const model::BallGeometry geometry = fake.load()->device.geometry;
  EXPECT_EQ(geometry.removed_pins, (std::vector<int>{211, 7}));
  EXPECT_EQ(geometry.removed_shields, (std::vector<int>{0}));
  EXPECT_EQ(geometry.front_pin, 3);
  EXPECT_EQ(geometry.sizes, (model::ArraySizes{{4, 6, 1.2}, {2, 6, 1.2}, 50}));
  EXPECT_EQ(model::arrangement_of(geometry)->pins.size(), 210u);
  FakeFiles again = FakeFiles::with_device(print_device(fake.load()->device));
  ASSERT_EQ(again.errors(), "");
  EXPECT_EQ(again.load()->device, fake.load()->device);
}

TEST(DeviceFile, AMatrixMustReachEveryDirection) {
  EXPECT_EQ(wrong_device("{\n\"coil_matrix\": [[1, 0, 0], [0, 1, 0], [1, 1, 0]]}"),
            kDeviceFile +
                ":2: coil_matrix: must have a determinant other than 0: the coils do not span " +
                "all directions\n");
  EXPECT_EQ(wrong_device("{\"coil_matrix\": [[1, 0, 0], [0, 1], [0, 0, 1]]}"),
            kDeviceFile + ":1: coil_matrix: row 2: must be three rows of three numbers, such as " +
                "[[1, 0, 0], [0, 1, 0], [0, 0, 1]], not a list\n");
  EXPECT_EQ(wrong_device("{\"coil_matrix\": [[1, 0, 0], [0, 1, 0], [0, 0, 11]]}"),
            kDeviceFile + ":1: coil_matrix: row 3: number 3 must be -10 to 10, not 11\n");
}

TEST(DeviceFile, WrongValuesAreNamed) {
  EXPECT_EQ(wrong_device("{\"r25_ohm\": [0.45, 0, 0.45]}"),
            kDeviceFile + ":1: r25_ohm: number 2 must be 0.05 to 10, not 0\n");
  EXPECT_EQ(wrong_device("{\"thermal\": {\"sensor_winding\": 3}}"),
            kDeviceFile + ":1: thermal.sensor_winding: must be 0 to 2, not 3\n");
  EXPECT_EQ(wrong_device("{\"arrangement\": \"cD-42\"}"),
            kDeviceFile +
                ":1: arrangement: unknown array 'cD-42': known are cD, wD, tkD, D, tI, GP(m,n), " +
                "tkD-86, tkD-86-5 and tkD-86-20\n");
  EXPECT_EQ(wrong_device("{\"removed_pins\": 3}"),
            kDeviceFile + ":1: removed_pins: must be a list of numbers, not 3\n");
  EXPECT_EQ(wrong_device("{\"pin_magnet_mm\": [8]}"),
            kDeviceFile +
                ":1: pin_magnet_mm: must be diameter and height in mm, such as [8, 10], " +
                "not a list\n");
  EXPECT_EQ(wrong_device("{\"limits\": {\"trip_c\": 90}}"),
            kDeviceFile + ":1: limits.trip_c: must be 30 to 75, not 90\n");
  EXPECT_EQ(wrong_device("{\"name\": \"my ball\"}"),
            kDeviceFile + ":1: name: must be a name of 1 to 32 letters, digits, \"-\", \"_\" or " +
                "\".\", not \"my ball\"\n");
  EXPECT_EQ(wrong_device("{\"resistance_ohm\": 1}"),
            kDeviceFile + ":1: resistance_ohm: unknown key\n");
}

TEST(DeviceFile, AnImpossibleGeometryNamesTheInvalidKey) {
  EXPECT_EQ(wrong_device("{\n\"arrangement\": \"wD\",\n\"front_pin\": 72}"),
            kDeviceFile + ":3: front_pin: there is no pin 72 to be the front\n");
  EXPECT_EQ(wrong_device("{\n\"arrangement\": \"wD\",\n\"front_pin\": 0}"),
            kDeviceFile + ":3: front_pin: pin 0 is at a pole and shows no front\n");
  EXPECT_EQ(wrong_device("{\n\"arrangement\": \"cD\", \"front_pin\": 1,\n\"removed_pins\": [42]}"),
            kDeviceFile + ":3: removed_pins: there is no pin 42 to remove\n");
  EXPECT_EQ(wrong_device("{\n\"arrangement\": \"cD\",\n\"removed_shields\": [3, 80]}"),
            kDeviceFile + ":3: removed_shields: there is no shield 80 to remove\n");
  EXPECT_EQ(wrong_device("{\n\"removed_pins\": [3, 17, 3]}"),
            kDeviceFile + ":2: removed_pins: names 3 twice\n");
  EXPECT_EQ(wrong_device("{\n\"removed_pins\": [86]}"),
            kDeviceFile + ":2: removed_pins: there is no pin 86 to remove\n");
  const auto key_of_overlap = [](const std::string& text) {
    const std::string wrong = wrong_device(text);
    const std::size_t reason = wrong.find(": pin ");
    EXPECT_NE(wrong.find("overlap by"), std::string::npos) << wrong;
    return wrong.substr(kDeviceFile.size(), reason - kDeviceFile.size());
  };
  EXPECT_EQ(key_of_overlap("{\n\"shield_magnet_mm\": [5, 10]}"), ":2: shield_magnet_mm");
  EXPECT_EQ(key_of_overlap("{\n\"pin_magnet_mm\": [9, 10]}"), ":2: pin_magnet_mm");
  EXPECT_EQ(key_of_overlap("{\n\"sphere_mm\": 30}"), ":2: sphere_mm");
  EXPECT_EQ(key_of_overlap("{\n\"arrangement\": \"GP(4,1)\"}"), ":2: arrangement");
}

// The check computes the whole array, up to seconds: it is not repeated for the geometry in use.
TEST(DeviceFile, AGeometryInUseIsNotCheckedAgain) {
  const FakeFiles fake = FakeFiles::with_device("{\"sphere_mm\": 30}");
  ASSERT_THAT(fake.errors(), testing::HasSubstr("overlap by"));
  Config running;
  running.device.geometry.sizes.sphere_radius_mm = 30.0;
  EXPECT_TRUE(fake.load(&running).has_value()) << "taken as checked when it was loaded";
  running.device.geometry.sizes.sphere_radius_mm = 31.0;
  EXPECT_FALSE(fake.load(&running).has_value());
}

TEST(DeviceFile, OfTheSimulatedBallHasThePinsOfTheDevice) {
  FakeFiles fake = FakeFiles::with(
      R"({"backend": "simulator", "device": "mine", "simulator": {"device": "true"}})");
  fake.files[kDeviceFile] = "{}";
  std::string& true_device = fake.files["/etc/hedgehog/devices.d/true.json"];
  true_device = R"({"shield_magnet_mm": [3.9, 10], "removed_shields": [0]})";
  EXPECT_EQ(fake.errors(), "");
  for (const char* other :
       {R"({"arrangement": "tkD-86-5"})", R"({"removed_pins": [3]})", R"({"front_pin": 2})"}) {
    true_device = other;
    EXPECT_THAT(fake.errors(), testing::HasSubstr("simulator.device: the simulated ball must have "
                                                  "the pins of device"))
        << other;
  }
}

TEST(DeviceFile, HeatThatTheEstimateCannotFollowIsRefused) {
  EXPECT_EQ(wrong_device("{\"thermal\": {\n\"winding_j_k\": 2, \"winding_to_core_k_w\": 0.4}}"),
            kDeviceFile + ":2: thermal.winding_j_k: times winding_to_core_k_w must be at least 1 " +
                "s, not 0.8: too fast for the thermal estimate\n");
  EXPECT_EQ(wrong_device("{\"thermal\": {\"core_j_k\": 2.5, \"core_to_room_fan_k_w\": 1}}"),
            kDeviceFile + ":1: thermal.core_j_k: over all conductances of the core must be at " +
                "least 1 s, not 0.625: too fast for the thermal estimate\n");
  EXPECT_EQ(wrong_device("{\"thermal\": {\"sensor_lag_s\": 0}}"),
            kDeviceFile + ":1: thermal.sensor_lag_s: must be 0.1 to 10, not 0\n");
  EXPECT_EQ(FakeFiles::with_device("{\"thermal\": {\"winding_j_k\": 2, \"winding_to_core_k_w\": "
                                   "0.5, \"core_j_k\": 7}}")
                .errors(),
            "");
}

TEST(DeviceFile, WithoutUncertaintiesTwentyPercentAreAssumed) {
  EXPECT_EQ(FakeFiles::with_device("{}").load()->device.uncertainty,
            (model::ThermalUncertainty{0.2, 0.03, 0.5}));
}

TEST(DeviceFile, AnImplausiblySmallUncertaintyIsRefused) {
  EXPECT_EQ(wrong_device("{\"uncertainty\": {\"thermal\": 0.01}}"),
            kDeviceFile + ":1: uncertainty.thermal: must be 0.05 to 0.5, not 0.01\n");
  EXPECT_EQ(wrong_device("{\"uncertainty\": {\"resistance\": 0.009}}"),
            kDeviceFile + ":1: uncertainty.resistance: must be 0.01 to 0.2, not 0.009\n");
  EXPECT_EQ(wrong_device("{\"uncertainty\": {\"thermistor_k\": 0}}"),
            kDeviceFile + ":1: uncertainty.thermistor_k: must be 0.3 to 3, not 0\n");
  EXPECT_EQ(wrong_device("{\"uncertainty\": 0.05}"),
            kDeviceFile + ":1: uncertainty: must be an object, not 0.05\n");
  EXPECT_EQ(wrong_device("{\"thermal\": {\"winding_j_k\": [60, 60]}}"),
            kDeviceFile +
                ":1: thermal.winding_j_k: must be one number, or three: of x, y, z, not a list\n");
  EXPECT_EQ(wrong_device("{\"thermal\": {\"winding_j_k\": [60, 0, 60]}}"),
            kDeviceFile + ":1: thermal.winding_j_k: number 2 must be 1 to 10000, not 0\n");
}

TEST(DeviceFile, UsbIdsAreHexadecimalPairs) {
  for (const std::string id : {"1209", "1209:1", "1209-0001", "12g9:0001", "+209:0001", ""}) {
    EXPECT_EQ(wrong_device("{\"usb\": [\"" + id + "\"]}"),
              kDeviceFile +
                  ":1: usb: must be a list of \"vendor:product\" in hexadecimal, such as " +
                  "[\"1209:0001\"], not \"" + id + "\"\n");
  }
}

RC_GTEST_PROP(DeviceFile, AMatrixLoadsExactlyWhenItCanBeInverted, ()) {
  model::Mat3 matrix;
  std::string rows;
  bool in_range = true;
  for (int r = 0; r < 3; ++r) {
    rows += (r > 0 ? ",[" : "[");
    for (int c = 0; c < 3; ++c) {
      const int number = *rc::gen::inRange(-11, 12);
      in_range = in_range && number >= -10 && number <= 10;
      matrix.row[r][c] = number;
      rows += (c > 0 ? "," : "") + std::to_string(number);
    }
    rows += "]";
  }
  const auto loaded = FakeFiles::with_device("{\"coil_matrix\": [" + rows + "]}").load();
  RC_ASSERT(loaded.has_value() == (in_range && model::determinant(matrix) != 0.0));
  if (!loaded) return;
  const model::CoilModel& coils = loaded->device.coils;
  const model::Vec3 field{1.0, -2.0, 3.0};
  const model::Vec3 back = model::field_of(model::currents_for({field}, coils), coils).a;
  RC_ASSERT(model::norm(back - field) < 1e-6);
}

TEST(DeviceFile, TheSimulatedBallIsTheDaemonsUnlessAnotherFileIsConfigured) {
  FakeFiles fake = FakeFiles::with_device(R"({"r25_ohm": [0.41, 0.42, 0.43]})");
  EXPECT_EQ(fake.load()->simulated_ball().coils.r25_ohm[2], 0.43);

  fake = FakeFiles::with(R"({"simulator": {"device": "truth"}})");
  EXPECT_EQ(fake.errors(),
            "/etc/hedgehog/hedgehogd.json:1: simulator.device: there is no "
            "/etc/hedgehog/devices.d/truth.json or /usr/share/hedgehog/devices.d/truth.json\n");
  std::string& true_device = fake.files["/etc/hedgehog/devices.d/truth.json"];
  true_device = R"({"r25_ohm": 1})";
  EXPECT_EQ(fake.errors().find("/etc/hedgehog/devices.d/truth.json:1: r25_ohm: "), 0u);
  true_device = R"({"r25_ohm": [0.5, 0.4, 0.6]})";
  const Config before = *fake.load();
  EXPECT_EQ(before.simulated_ball().coils.r25_ohm[0], 0.5);
  EXPECT_EQ(before.device.coils.r25_ohm[0], 0.45) << "what is believed is another matter";
  true_device = "{}";
  EXPECT_EQ(different_keys(before, *fake.load()), std::vector<std::string>{"simulator.device"});

  fake = FakeFiles::with(R"({"backend": "usb", "simulator": {"device": "gone"}})");
  EXPECT_EQ(fake.errors(), "") << "what was rehearsed does not stop a daemon of a real ball";
}

TEST(DeviceFile, AChangeOfItsContentIsADifferenceToo) {
  const Config before = *FakeFiles::with_device(R"({"r25_ohm": [0.41, 0.42, 0.43]})").load();
  const Config after = *FakeFiles::with_device(R"({"r25_ohm": [0.41, 0.42, 0.44]})").load();
  EXPECT_EQ(different_keys(before, after), std::vector<std::string>{"device"});
  EXPECT_TRUE(different_keys(before, before).empty());
}

// Overrides slightly below and above the ball's limits: every accepted value is within them.
RC_GTEST_PROP(DeviceFile, ConfigurationNeverLoosens, ()) {
  constexpr int kAbsent = -100;
  std::string members;
  for (const LimitField& field : kLimitFields) {
    const int tenths = *rc::gen::element(kAbsent, kAbsent, -7, -3, 0, 1);
    if (tenths == kAbsent) continue;
    const double value = model::Limits{}.*field.member + 0.1 * tenths;
    members +=
        (members.empty() ? "\"" : ",\"") + std::string(field.name) + "\":" + std::to_string(value);
  }
  const FakeFiles fake = FakeFiles::with("{\"limits\": {" + members + "}}");
  const auto loaded = fake.load();
  RC_CLASSIFY(loaded.has_value());
  if (!loaded) return;
  RC_ASSERT(model::is_within(loaded->limits, loaded->device.limits));
  RC_ASSERT(loaded->limits.zero_c < loaded->limits.trip_c);
  RC_ASSERT(loaded->limits.continuous_a <= loaded->limits.current_a);
}

}  // namespace
}  // namespace hedgehog::config
