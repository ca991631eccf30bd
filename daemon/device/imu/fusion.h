// SPDX-License-Identifier: MIT
// Orientation from a gyroscope and an accelerometer. No magnetometer: next to the ball's magnet the
// direction of north cannot be measured. Roll and pitch are corrected by gravity, and yaw drifts
// with the residual bias of the gyroscope.
//
// The filter is the explicit complementary filter with bias estimation of Mahony, Hamel and
// Pflimlin, "Nonlinear Complementary Filters on the Special Orthogonal Group", IEEE Transactions on
// Automatic Control 53 (2008), section V, for one reference direction. Two parts follow Laidig and
// Seel, "VQF", Information Fusion 91 (2023): acceleration is averaged in the world's axes, where
// the pushes of a hand cancel out, before it is used as gravity; and the bias around the vertical,
// which gravity does not determine, is the mean rate while the sensor is at rest.
#pragma once

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// REP-103 axes of the sensor.
struct MotionSample {
  model::Vec3 rate_deg_s;
  /// Specific force, g: at rest it points away from the earth.
  model::Vec3 accel_g;
  /// Time since the previous sample, s.
  double dt_s = 0.0;
};

/// One thread; trivially copyable; no allocation.
class Fusion {
 public:
  /// Gain of gravity on the estimate, 1/s: 1/kPull is the time constant of a tilt error. It is
  /// higher for the first kSettleS.
  static constexpr double kPull = 0.5;
  static constexpr double kPullAtFirst = 5.0;
  static constexpr double kSettleS = 2.0;
  /// Gain of the bias estimate, 1/s^2.
  static constexpr double kBiasGain = 0.02;
  /// Averaging time of the acceleration, s. Samples further than kTrustG from 1 g are not used.
  static constexpr double kGravityS = 1.0;
  static constexpr double kTrustG = 0.5;
  /// At rest: rate and acceleration have stayed within these bounds of their slow means for
  /// kStillS.
  static constexpr double kStillDegS = 2.0;
  static constexpr double kStillG = 0.06;
  static constexpr double kStillS = 1.0;
  /// Time constant with which the bias follows the mean rate at rest, s.
  static constexpr double kRestS = 2.0;
  /// Maximum bias of a calibrated gyroscope, deg/s. A steady rotation slower than this is treated
  /// as bias.
  static constexpr double kMaxBiasDegS = 3.0;

  /// Applies the next sample. Ignored if a number in it is not finite or out of range, or `dt_s` is
  /// not within 0..0.5 s; the first one sets roll and pitch, with the front at azimuth 0.
  void step(const MotionSample& sample) noexcept;

  /// After an unobserved rotation: the next sample sets roll and pitch, and is weighted like the
  /// first one. The gyroscope's bias is kept; so is the heading, as if the sensor had been tilted
  /// by the shortest rotation.
  void restart() noexcept;

  /// False until the first sample.
  bool started() const noexcept { return started_; }
  /// Sensor -> world, z up. Unit length.
  const model::Quaternion& sensor_to_world() const noexcept { return q_; }
  /// The last rate without its bias, and the bias.
  const model::Vec3& rate_deg_s() const noexcept { return rate_deg_s_; }
  const model::Vec3& bias_deg_s() const noexcept { return bias_deg_s_; }
  bool still() const noexcept { return still_s_ >= kStillS; }

 private:
  /// Tilts the estimate by the shortest rotation to the measured "up".
  void level(const model::Vec3& accel_g) noexcept;
  void start(const model::Vec3& accel_g) noexcept;
  void watch_rest(const MotionSample& sample) noexcept;
  /// In the world's axes: sine of the tilt error, about the axis that corrects it.
  model::Vec3 tilt_error() const noexcept;

  bool started_ = false;
  bool no_sample_ = true;
  double age_s_ = 0.0;
  model::Quaternion q_;
  model::Vec3 rate_deg_s_;
  model::Vec3 bias_deg_s_;
  /// Mean acceleration, world's axes.
  model::Vec3 gravity_g_{0, 0, 1};
  // Slow means for the detection of rest.
  model::Vec3 mean_rate_deg_s_;
  model::Vec3 mean_accel_g_;
  double still_s_ = 0.0;
};

}  // namespace hedgehog::device
