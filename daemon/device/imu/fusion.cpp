// SPDX-License-Identifier: MIT
#include "daemon/device/imu/fusion.h"

#include <algorithm>
#include <cmath>

#include "model/units.h"

namespace hedgehog::device {
namespace {

using model::Quaternion;
using model::Vec3;

constexpr double kMaxDegS = 1e4;
constexpr double kMaxG = 100.0;
constexpr double kMaxDtS = 0.5;
/// Time constant of the means used to detect rest.
constexpr double kMeanS = 0.5;

Quaternion normalised(const Quaternion& q) noexcept {
  const double k = 1.0 / norm(q);
  return {k * q.w, k * q.x, k * q.y, k * q.z};
}

/// Exact for a constant rate over the step.
Quaternion turned(const Quaternion& q, const Vec3& rate_rad_s, double dt_s) noexcept {
  const double angle = norm(rate_rad_s) * dt_s;
  // sin(a/2)/a without a division by zero
  const double share = angle > 1e-9 ? std::sin(angle / 2) / angle : 0.5;
  const Vec3 v = (share * dt_s) * rate_rad_s;
  return normalised(q * Quaternion{std::cos(angle / 2), v.x, v.y, v.z});
}

bool is_plausible(const MotionSample& s) noexcept {
  return norm(s.rate_deg_s) < kMaxDegS && norm(s.accel_g) < kMaxG && s.dt_s > 0.0 &&
         s.dt_s <= kMaxDtS;
}

}  // namespace

void Fusion::restart() noexcept {
  no_sample_ = true;
  age_s_ = 0.0;
  gravity_g_ = {0, 0, 1};
  still_s_ = 0.0;
}

void Fusion::level(const Vec3& accel_g) noexcept {
  const Vec3 up = unit_or(rotate(q_, accel_g), {0, 0, 1});
  const Quaternion tilt =
      up.z > -0.999 ? normalised({1.0 + up.z, up.y, -up.x, 0.0}) : Quaternion{0, 1, 0, 0};
  q_ = normalised(tilt * q_);
}

void Fusion::start(const Vec3& accel_g) noexcept {
  level(accel_g);
  // and rotates the front to azimuth 0
  const Vec3 front = rotate(q_, {1, 0, 0});
  const bool flat = std::hypot(front.x, front.y) > 1e-3;
  const double yaw = flat ? std::atan2(front.y, front.x) : 0.0;
  q_ = normalised(model::axis_angle({0, 0, 1}, -yaw / model::kRadiansPerDegree) * q_);
  started_ = true;
}

void Fusion::watch_rest(const MotionSample& s) noexcept {
  const double share = std::min(1.0, s.dt_s / kMeanS);
  mean_rate_deg_s_ = mean_rate_deg_s_ + share * (s.rate_deg_s - mean_rate_deg_s_);
  mean_accel_g_ = mean_accel_g_ + share * (s.accel_g - mean_accel_g_);
  const bool quiet = norm(s.rate_deg_s - mean_rate_deg_s_) < kStillDegS &&
                     norm(s.accel_g - mean_accel_g_) < kStillG &&
                     norm(mean_rate_deg_s_) < kMaxBiasDegS;
  still_s_ = quiet ? std::min(still_s_ + s.dt_s, 1e3) : 0.0;
}

Vec3 Fusion::tilt_error() const noexcept {
  const double length = norm(gravity_g_);
  return length > 1.0 - kTrustG ? (1.0 / length) * cross(gravity_g_, {0, 0, 1}) : Vec3{};
}

void Fusion::step(const MotionSample& s) noexcept {
  if (!is_plausible(s)) return;
  if (no_sample_) {
    started_ ? level(s.accel_g) : start(s.accel_g);
    mean_accel_g_ = s.accel_g;
    mean_rate_deg_s_ = s.rate_deg_s;
    no_sample_ = false;
  }
  age_s_ = std::min(age_s_ + s.dt_s, 1e6);
  watch_rest(s);

  if (still()) {
    const double share = std::min(1.0, s.dt_s / kRestS);
    bias_deg_s_ = bias_deg_s_ + share * (mean_rate_deg_s_ - bias_deg_s_);
  } else if (age_s_ >= kSettleS) {
    const Vec3 error = rotate(conjugate(q_), tilt_error());
    bias_deg_s_ = bias_deg_s_ - (kBiasGain * s.dt_s / model::kRadiansPerDegree) * error;
  }
  for (int axis = 0; axis < 3; ++axis)
    bias_deg_s_[axis] = std::clamp(bias_deg_s_[axis], -kMaxBiasDegS, kMaxBiasDegS);
  rate_deg_s_ = s.rate_deg_s - bias_deg_s_;
  q_ = turned(q_, model::kRadiansPerDegree * rate_deg_s_, s.dt_s);

  if (std::abs(norm(s.accel_g) - 1.0) < kTrustG) {
    const double share = std::min(1.0, s.dt_s / std::min(kGravityS, age_s_));
    gravity_g_ = gravity_g_ + share * (rotate(q_, s.accel_g) - gravity_g_);
  }
  // The mean is rotated too, so that a correction is not applied twice.
  const double pull = age_s_ < kSettleS ? kPullAtFirst : kPull;
  const Quaternion correction = turned({}, pull * tilt_error(), s.dt_s);
  q_ = normalised(correction * q_);
  gravity_g_ = rotate(correction, gravity_g_);
}

}  // namespace hedgehog::device
