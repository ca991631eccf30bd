// SPDX-License-Identifier: MIT
// A Sony pad over a fake port: its own clock, its mounting, and rotations while it was not
// connected.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "daemon/device/sensors/imu_sensors.h"
#include "tests/device/sensors/fake_ports.h"

namespace hedgehog::device {
namespace {

using namespace std::chrono_literals;

constexpr double kRadians = 3.14159265358979323846 / 180.0;

/// A report of a DualSense on USB that rotates about its up axis, or is tilted to its side.
std::vector<Byte> dualsense_report(std::uint32_t clock, std::int16_t yaw, double tilt_deg = 0.0) {
  std::vector<Byte> bytes(64);
  bytes[0] = 1;
  const auto put = [&](std::size_t at, std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i)
      bytes[at + static_cast<std::size_t>(i)] = static_cast<Byte>(value >> (8 * i));
  };
  put(18, static_cast<std::uint16_t>(yaw), 2);
  const auto gravity = [](double share) {
    return static_cast<std::uint32_t>(std::lround(8192.0 * share)) & 0xFFFF;
  };
  put(22, gravity(std::sin(tilt_deg * kRadians)), 2);
  put(24, gravity(std::cos(tilt_deg * kRadians)), 2);
  put(28, clock, 4);
  return bytes;
}

TEST(SonyImu, TurnsByThePadsOwnClock) {
  Desk desk;
  FakeHid pad;
  SonyImu imu(SonyPad::kDualSense, pad.opener(), desk.orientation());
  ASSERT_EQ(imu.open(), "") << "without a calibration report the nominal scale is used";
  // 90 deg/s for a second, in reports of 4 ms that arrive in bursts.
  const auto raw = static_cast<std::int16_t>(std::lround(90.0 / 2048.0 * 32767.0));
  for (std::uint32_t i = 0; i <= 250; ++i) pad.reports.push_back(dualsense_report(i * 12000, raw));
  while (!pad.reports.empty()) ASSERT_TRUE(imu.poll(0ms));
  const model::Vec3 front = rotate(desk.samples.back().quaternion, {1, 0, 0});
  EXPECT_NEAR(std::atan2(front.y, front.x) * 180 / 3.14159265, 90.0, 0.5);
  EXPECT_NEAR(desk.samples.back().rate_deg_s.z, 90.0, 0.5);
}

// Unplugged, or out of radio range, and turned onto its back meanwhile.
TEST(SonyImu, AnUnmeasuredTurnIsCorrectedWithinTheSettleTime) {
  Desk desk;
  FakeHid pad;
  SonyImu imu(SonyPad::kDualSense, pad.opener(), desk.orientation());
  ASSERT_EQ(imu.open(), "");
  std::uint32_t clock = 0;
  const auto rest_s = [&](double seconds, double tilt_deg) {
    for (int i = 0; i < seconds * 250.0; ++i, desk.now += 4) {
      pad.reports.push_back(dualsense_report(clock += 12000, 0, tilt_deg));
      ASSERT_TRUE(imu.poll(0ms));
    }
  };
  const auto tilt_deg = [&] {
    const model::Vec3 up = rotate(conjugate(desk.samples.back().quaternion), {0, 0, 1});
    return std::acos(std::clamp(up.z, -1.0, 1.0)) / kRadians;
  };
  rest_s(4.0, 0.0);
  EXPECT_NEAR(tilt_deg(), 0.0, 1.0);

  pad.plugged = false;
  EXPECT_FALSE(imu.poll(0ms));
  imu.close();
  desk.now += 5000;
  pad.plugged = true;
  ASSERT_EQ(imu.open(), "");
  clock = 77;
  rest_s(Fusion::kSettleS, 175.0);
  EXPECT_NEAR(tilt_deg(), 175.0, 1.0) << "plugged in again";

  clock += 3'000'000;  // 1 s
  rest_s(Fusion::kSettleS, 0.0);
  EXPECT_NEAR(tilt_deg(), 0.0, 1.0) << "heard again";
  EXPECT_LT(norm(imu.fusion().bias_deg_s()), 0.05) << "and nothing of it was taken for bias";

  // By the pad's clock, which wraps around, no time has passed.
  desk.now += 1000;
  rest_s(Fusion::kSettleS, 175.0);
  EXPECT_NEAR(tilt_deg(), 175.0, 1.0) << "heard again after whole rounds of its clock";
}

TEST(SonyImu, AMountingUpsideDownIsTurnedBack) {
  Desk desk;
  FakeHid pad;
  SonyImu imu(SonyPad::kDualSense, pad.opener(),
              desk.orientation(*Mounting::of(Side::kFront, Side::kDown)));
  ASSERT_EQ(imu.open(), "");
  for (std::uint32_t i = 0; i < 5; ++i) pad.reports.push_back(dualsense_report(i * 12000, 0));
  while (!pad.reports.empty()) ASSERT_TRUE(imu.poll(0ms));
  // The pad lies face up and is mounted face down: so the ball is upside down.
  EXPECT_NEAR(rotate(desk.samples.back().quaternion, {0, 0, 1}).z, -1.0, 1e-6);
}

}  // namespace
}  // namespace hedgehog::device
