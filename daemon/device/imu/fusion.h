// SPDX-License-Identifier: MIT
// Orientation from a gyroscope and an accelerometer. No magnetometer, because of the ball's magnet:
// gravity corrects roll and pitch, and yaw drifts with the residual bias of the gyroscope.
//
// Explicit complementary filter with bias estimation of Mahony, Hamel and Pflimlin, "Nonlinear
// Complementary Filters on the Special Orthogonal Group", IEEE Transactions on Automatic Control 53
// (2008), section V, for one reference direction. As in Laidig and Seel, "VQF", Information Fusion
// 91 (2023), acceleration is averaged in the world's axes, where the pushes of a hand cancel out,
// and the bias around the vertical is the mean rate while the sensor is at rest.
#pragma once

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// REP-103 axes of the sensor.
struct MotionSample {
  model::Vec3 rate_deg_s;
  model::Vec3 accel_g;  // specific force: at rest it points away from the earth
  double dt_s = 0.0;    // since the previous sample
};

/// One thread; trivially copyable; no allocation.
class Fusion {
 public:
  /// Gain of gravity on the estimate, 1/s: 1 / time constant of a tilt error. Higher for kSettleS.
  static constexpr double kPull = 0.5;
  static constexpr double kPullAtFirst = 5.0;
  static constexpr double kSettleS = 2.0;
  static constexpr double kBiasGain = 0.02;  // of the bias estimate, 1/s^2
  /// Averaging time of the acceleration. Samples further than kTrustG from 1 g are not used.
  static constexpr double kGravityS = 1.0;
  static constexpr double kTrustG = 0.5;
  /// At rest: rate and acceleration within these bounds of their slow means for kStillS.
  static constexpr double kStillDegS = 2.0;
  static constexpr double kStillG = 0.06;
  static constexpr double kStillS = 1.0;
  static constexpr double kRestS = 2.0;        // time constant of the bias at rest
  static constexpr double kMaxBiasDegS = 3.0;  // a steady slower rotation is treated as bias

  /// Ignored if a number is not finite or out of range, or `dt_s` is not within 0..0.5 s. The first
  /// one sets roll and pitch, with the front at azimuth 0.
  void step(const MotionSample& sample) noexcept;

  /// After an unobserved rotation: the next sample sets roll and pitch, weighted like the first
  /// one. Bias and heading are kept, the latter as if tilted by the shortest rotation.
  void restart() noexcept;

  bool started() const noexcept { return started_; }  // false until the first sample
  const model::Quaternion& sensor_to_world() const noexcept { return q_; }  // z up; unit length
  const model::Vec3& rate_deg_s() const noexcept { return rate_deg_s_; }    // without its bias
  const model::Vec3& bias_deg_s() const noexcept { return bias_deg_s_; }
  bool still() const noexcept { return still_s_ >= kStillS; }

 private:
  void level(const model::Vec3& accel_g) noexcept;  // tilts the estimate by the shortest rotation
  void start(const model::Vec3& accel_g) noexcept;
  void watch_rest(const MotionSample& sample) noexcept;
  model::Vec3 tilt_error() const noexcept;  // sine, about the correcting axis, world's axes

  bool started_ = false;
  bool no_sample_ = true;
  double age_s_ = 0.0;
  model::Quaternion q_;
  model::Vec3 rate_deg_s_;
  model::Vec3 bias_deg_s_;
  model::Vec3 gravity_g_{0, 0, 1};  // mean acceleration, world's axes
  model::Vec3 mean_rate_deg_s_;     // slow means, to detect rest
  model::Vec3 mean_accel_g_;
  double still_s_ = 0.0;
};

}  // namespace hedgehog::device
