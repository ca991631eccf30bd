// SPDX-License-Identifier: MIT
// Orientation out of a gyroscope and an accelerometer. No magnetometer: beside this magnet there is
// no north. So roll and pitch are held by gravity, and yaw drifts with what is left of the
// gyroscope's bias.
//
// The filter is the explicit complementary filter with bias estimation of Mahony, Hamel and
// Pflimlin, "Nonlinear Complementary Filters on the Special Orthogonal Group", IEEE Transactions on
// Automatic Control 53 (2008), section V, for one reference direction. Two things are as in Laidig
// and Seel, "VQF", Information Fusion 91 (2023): acceleration is averaged in the world's axes,
// where the pushes of a hand cancel out, before it is taken for gravity; and the bias around the
// vertical, of which gravity says nothing, is the mean rate while the sensor lies still.
#pragma once

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// REP-103 axes of the sensor.
struct MotionSample {
  model::Vec3 rate_deg_s;
  /// What an accelerometer feels, in g: at rest it points away from the earth.
  model::Vec3 accel_g;
  /// Since the sample before.
  double dt_s = 0.0;
};

/// One thread; trivially copyable; no allocation.
class Fusion {
 public:
  /// Pull of gravity on the estimate, 1/s: 1/kPull is the time in which an error of tilt falls to
  /// 1/e. For the first kSettleS it is stronger.
  static constexpr double kPull = 0.5;
  static constexpr double kPullAtFirst = 5.0;
  static constexpr double kSettleS = 2.0;
  /// How fast the bias follows, 1/s^2.
  static constexpr double kBiasGain = 0.02;
  /// Time over which acceleration is averaged, s. Samples further than kTrustG from 1 g are left
  /// out.
  static constexpr double kGravityS = 1.0;
  static constexpr double kTrustG = 0.5;
  /// Still: rate and acceleration have kept within this of their slow means for kStillS.
  static constexpr double kStillDegS = 2.0;
  static constexpr double kStillG = 0.06;
  static constexpr double kStillS = 1.0;
  /// While still, the bias follows the mean rate with this time constant, s.
  static constexpr double kRestS = 2.0;
  /// No calibrated gyroscope is off by more, deg/s. A steady turn slower than this is taken for
  /// bias.
  static constexpr double kMaxBiasDegS = 3.0;

  /// The next sample. Ignored when a number in it is not finite or out of range, or `dt_s` is not
  /// within 0..0.5 s; the first one gives roll and pitch at once, with the front at azimuth 0.
  void step(const MotionSample& sample) noexcept;

  /// It may have been turned unseen: the next sample gives roll and pitch at once, and is followed
  /// as the first one is. The gyroscope's bias stays; so does the heading, as if it had been tilted
  /// the shortest way.
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
  /// Tilts the estimate the shortest way to where "up" is felt.
  void level(const model::Vec3& accel_g) noexcept;
  void start(const model::Vec3& accel_g) noexcept;
  void watch_rest(const MotionSample& sample) noexcept;
  /// In the world's axes: sine of the tilt error, about the axis that mends it.
  model::Vec3 tilt_error() const noexcept;

  bool started_ = false;
  bool unseen_ = true;
  double age_s_ = 0.0;
  model::Quaternion q_;
  model::Vec3 rate_deg_s_;
  model::Vec3 bias_deg_s_;
  /// Mean acceleration, world's axes.
  model::Vec3 gravity_g_{0, 0, 1};
  // Slow means, to see rest by.
  model::Vec3 mean_rate_deg_s_;
  model::Vec3 mean_accel_g_;
  double still_s_ = 0.0;
};

}  // namespace hedgehog::device
