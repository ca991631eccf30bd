// SPDX-License-Identifier: MIT
// The 6-axis filter against motions with known answers, and the mounting of a sensor.
#include "daemon/device/imu/fusion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "daemon/device/imu/mounting.h"
#include "model/random_stream.h"

namespace hedgehog::device {
namespace {

using model::Quaternion;
using model::Vec3;

constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr double kDt = 1.0 / 250.0;

/// Angle between two rotations; and between their "up" vectors, which covers roll and pitch alone.
double angle_deg(const Quaternion& a, const Quaternion& b) {
  const Quaternion d = conjugate(a) * b;
  return 2.0 * std::atan2(std::hypot(d.x, d.y, d.z), std::abs(d.w)) * kDegrees;
}
double tilt_deg(const Quaternion& a, const Quaternion& b) {
  const Vec3 up_a = rotate(conjugate(a), {0, 0, 1});
  const Vec3 up_b = rotate(conjugate(b), {0, 0, 1});
  return std::atan2(norm(cross(up_a, up_b)), dot(up_a, up_b)) * kDegrees;
}

/// A consumer MEMS sensor, somewhat worse than the data sheets of the pads' sensors: bias, its
/// random walk, white noise of the rate and of the acceleration at 250 Hz, and an accelerometer
/// offset of 5 mg.
struct InertialSensor {
  model::RandomStream random{1};
  Vec3 bias_deg_s;
  double rate_noise_deg_s = 0.1;
  double walk_deg_s = 0.0005;  // per root second
  double accel_noise_g = 0.008;
  Vec3 accel_bias_g{0.003, -0.003, 0.003};

  Vec3 noise(double deviation) {
    return deviation * Vec3{random.gaussian(), random.gaussian(), random.gaussian()};
  }
  MotionSample sample(const Quaternion& orientation, const Vec3& rate_deg_s,
                      const Vec3& moving_g = {}) {
    bias_deg_s = bias_deg_s + noise(walk_deg_s * std::sqrt(kDt));
    const Vec3 up = rotate(conjugate(orientation), Vec3{0, 0, 1} + moving_g);
    return {rate_deg_s + bias_deg_s + noise(rate_noise_deg_s),
            up + accel_bias_g + noise(accel_noise_g), kDt};
  }
  /// Without noise, walk and bias.
  static InertialSensor ideal() {
    InertialSensor made;
    made.rate_noise_deg_s = made.walk_deg_s = made.accel_noise_g = 0.0;
    made.accel_bias_g = {};
    return made;
  }
};

/// The true orientation and the filter's, side by side.
struct FusionBench {
  InertialSensor sensor_model;
  Quaternion orientation;
  Fusion fusion;

  void rest(double seconds) { turn({0, 0, 1}, 0.0, seconds); }
  /// By `angle` about an axis of the sensor.
  void turn(const Vec3& axis, double angle, double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds / kDt));
    const double rate = angle / seconds;
    for (int i = 0; i < steps; ++i) {
      orientation = orientation * model::axis_angle(axis, rate * kDt);
      fusion.step(sensor_model.sample(orientation, rate * axis));
    }
  }
  double error_deg() const { return angle_deg(orientation, fusion.sensor_to_world()); }
  double tilt_error_deg() const { return tilt_deg(orientation, fusion.sensor_to_world()); }
};

RC_GTEST_PROP(FusionLaws, StaticTiltIsRightAtOnceAndStays, ()) {
  const double azimuth = *rc::gen::inRange(0, 360);
  const double tilt = *rc::gen::inRange(0, 181);
  FusionBench bench;
  bench.sensor_model.random = model::RandomStream(*rc::gen::arbitrary<std::uint64_t>());
  const Vec3 axis = rotate(model::axis_angle({0, 0, 1}, azimuth), {1, 0, 0});
  bench.orientation = model::axis_angle(axis, tilt);
  bench.rest(kDt);
  RC_ASSERT(bench.tilt_error_deg() < 4.0);  // one noisy sample
  bench.rest(4.0);
  RC_ASSERT(bench.tilt_error_deg() < 1.0);
  bench.rest(6.0);
  RC_ASSERT(bench.tilt_error_deg() < 1.0);
}

TEST(Fusion, TheFrontBeginsAtAzimuthZero) {
  FusionBench bench;
  bench.sensor_model = InertialSensor::ideal();
  bench.orientation = model::axis_angle({0, 0, 1}, 137.0) * model::axis_angle({0, 1, 0}, 20.0);
  bench.rest(kDt);
  const Vec3 front = rotate(bench.fusion.sensor_to_world(), {1, 0, 0});
  EXPECT_NEAR(front.y, 0.0, 1e-9);
  EXPECT_GT(front.x, 0.9);
}

// By hand, in 0.5 s and in 2 s, about each axis, in both directions.
TEST(Fusion, QuarterTurnsWithinTwoDegrees) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    for (const double angle : {90.0, -90.0, 180.0}) {
      for (const double seconds : {0.5, 2.0}) {
        FusionBench bench;
        bench.sensor_model.bias_deg_s = {0.4, -0.3, 0.5};
        bench.rest(5.0);
        bench.turn(axis, angle, seconds);
        EXPECT_LT(bench.error_deg(), 2.0) << axis.x << axis.y << axis.z << ' ' << angle;
        bench.rest(1.0);
        bench.turn(axis, -angle, seconds);
        EXPECT_LT(bench.error_deg(), 2.0) << axis.x << axis.y << axis.z << ' ' << angle;
      }
    }
  }
}

TEST(Fusion, TenMinutesOfNoiseMoveRollAndPitchByLessThanOneDegree) {
  FusionBench bench;
  bench.sensor_model.bias_deg_s = {0.8, -0.6, 0.5};
  double worst = 0.0;
  bench.rest(10.0);
  for (int second = 10; second < 600; ++second) {
    bench.rest(1.0);
    worst = std::max(worst, bench.tilt_error_deg());
  }
  RecordProperty("worst_tilt_mdeg", static_cast<int>(1000 * worst));
  RecordProperty("yaw_mdeg", static_cast<int>(1000 * bench.error_deg()));
  EXPECT_LT(worst, 1.0);
}

// A hand that is never still: 20 degrees back and forth about a changing axis, accelerations of 0.2
// g.
TEST(Fusion, RollAndPitchHoldForTenMinutesInAHand) {
  FusionBench bench;
  bench.sensor_model.bias_deg_s = {0.3, -0.4, 0.2};
  double worst = 0.0;
  bench.rest(5.0);
  for (int i = 0; i < 600 * 250; ++i) {
    const double t = i * kDt;
    const Vec3 rate{40 * std::cos(2.1 * t), 35 * std::cos(1.7 * t + 1), 30 * std::cos(1.3 * t + 2)};
    bench.orientation =
        bench.orientation * model::axis_angle(unit_or(rate, {1, 0, 0}), norm(rate) * kDt);
    const Vec3 push = 0.2 * std::sin(11 * t) * Vec3{0.7, 0.6, 0.39};
    bench.fusion.step(bench.sensor_model.sample(bench.orientation, rate, push));
    worst = std::max(worst, bench.tilt_error_deg());
  }
  RecordProperty("worst_tilt_mdeg", static_cast<int>(1000 * worst));
  EXPECT_LT(worst, 1.0);
}

TEST(Fusion, FindsTheBiasAtRestAroundEveryAxis) {
  FusionBench bench;
  bench.sensor_model.bias_deg_s = {1.2, -0.9, 1.5};
  bench.rest(15.0);
  EXPECT_TRUE(bench.fusion.still());
  EXPECT_LT(norm(bench.fusion.bias_deg_s() - bench.sensor_model.bias_deg_s), 0.05);
  EXPECT_LT(norm(bench.fusion.rate_deg_s()), 1.0);
}

TEST(Fusion, FindsTheBiasOfRollAndPitchInMotionToo) {
  FusionBench bench;
  bench.sensor_model.bias_deg_s = {1.0, -1.0, 0.0};
  for (int i = 0; i < 60; ++i) bench.turn({0, 0, 1}, i % 2 == 0 ? 60.0 : -60.0, 1.0);
  EXPECT_FALSE(bench.fusion.still());
  EXPECT_NEAR(bench.fusion.bias_deg_s().x, 1.0, 0.2);
  EXPECT_NEAR(bench.fusion.bias_deg_s().y, -1.0, 0.2);
}

// Shaken hard for a second, tilt is tracked by the gyroscope alone.
TEST(Fusion, AccelerationOtherThanGravityIsIgnored) {
  FusionBench bench;
  bench.rest(5.0);
  for (int i = 0; i < 250; ++i)
    bench.fusion.step(bench.sensor_model.sample(bench.orientation, {}, {1.5, 0.0, 0.0}));
  EXPECT_LT(bench.tilt_error_deg(), 1.0);
}

// The tilt is set again from gravity; heading and bias stay.
TEST(Fusion, AfterAnUnmeasuredTurnItIsRightWithinTheSettleTime) {
  for (const double tilt : {0.0, 40.0, 90.0, 150.0, 175.0}) {
    FusionBench bench;
    bench.sensor_model.bias_deg_s = {0.4, -0.3, 0.5};
    bench.rest(10.0);
    bench.turn({0, 0, 1}, 70.0, 1.0);
    bench.rest(3.0);
    bench.orientation = bench.orientation * model::axis_angle({0, 1, 0}, tilt);
    bench.fusion.restart();
    EXPECT_TRUE(bench.fusion.started());
    for (int i = 0; i < 10; ++i) {
      bench.rest(Fusion::kSettleS / 10);
      EXPECT_LT(norm(bench.fusion.bias_deg_s() - bench.sensor_model.bias_deg_s), 0.2) << tilt;
    }
    EXPECT_LT(bench.tilt_error_deg(), 1.0) << tilt;
    // Nearly upside down, the shortest rotation is ambiguous.
    const double heading_error = tilt > 150.0 ? 0.0 : bench.error_deg();
    EXPECT_LT(heading_error, 4.0) << tilt;
  }
}

TEST(Fusion, ImpossibleNumbersChangeNothing) {
  FusionBench bench;
  bench.rest(1.0);
  const Quaternion before = bench.fusion.sensor_to_world();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const MotionSample& bad :
       {MotionSample{{nan, 0, 0}, {0, 0, 1}, kDt}, MotionSample{{0, 0, 0}, {0, inf, 1}, kDt},
        MotionSample{{1e9, 0, 0}, {0, 0, 1}, kDt}, MotionSample{{0, 0, 0}, {0, 0, 1}, -kDt},
        MotionSample{{0, 0, 0}, {0, 0, 1}, 10.0}, MotionSample{{0, 0, 0}, {0, 0, 1}, nan}}) {
    bench.fusion.step(bad);
    EXPECT_EQ(bench.fusion.sensor_to_world(), before);
  }
}

RC_GTEST_PROP(FusionLaws, AnythingGivesARotation, ()) {
  Fusion fusion;
  const auto number =
      rc::gen::map(rc::gen::arbitrary<std::int16_t>(), [](int v) { return v / 4.0; });
  for (int i = 0; i < 50; ++i) {
    fusion.step({{*number, *number, *number}, {*number / 1e3, *number / 1e3, *number / 1e3}, kDt});
    RC_ASSERT(std::abs(norm(fusion.sensor_to_world()) - 1.0) < 1e-9);
    RC_ASSERT(norm(fusion.bias_deg_s()) <= std::sqrt(3.0) * Fusion::kMaxBiasDegS);
  }
}

// "Its left side faces the ball's front": relative to the ball, the sensor is rotated.
TEST(Mounting, SidesOfTheSensorBecomeTheBalls) {
  constexpr std::array<Side, 6> kSides{Side::kFront, Side::kBack, Side::kLeft,
                                       Side::kRight, Side::kUp,   Side::kDown};
  int possible = 0;
  for (const Side front : kSides) {
    for (const Side up : kSides) {
      const auto mounting = Mounting::of(front, up);
      if (!mounting) continue;
      ++possible;
      const Vec3 x = mounting->to_ball(normal(front));
      const Vec3 z = mounting->to_ball(normal(up));
      EXPECT_NEAR(x.x, 1.0, 1e-12);
      EXPECT_NEAR(z.z, 1.0, 1e-12);
      // In any orientation of the sensor, the ball's front is where the sensor's `front` side is.
      const Quaternion sensor = model::axis_angle({0.6, 0, 0.8}, 77.0);
      const Vec3 ball_front = rotate(mounting->ball_to_world(sensor), {1, 0, 0});
      EXPECT_LT(norm(ball_front - rotate(sensor, normal(front))), 1e-12);
    }
  }
  EXPECT_EQ(possible, 24);
  EXPECT_FALSE(Mounting::of(Side::kUp, Side::kUp));
  EXPECT_FALSE(Mounting::of(Side::kUp, Side::kDown));
}

}  // namespace
}  // namespace hedgehog::device
