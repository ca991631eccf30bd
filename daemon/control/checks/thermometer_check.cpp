// SPDX-License-Identifier: MIT
#include "daemon/control/checks/thermometer_check.h"

#include <algorithm>
#include <cmath>

#include "model/limit/shell_limit.h"

namespace hedgehog::control {

using device::ThermometerRole;

Reason ThermometerCheck::step(const ThermometerReading& in, double dt_s) noexcept {
  if (role_ == ThermometerRole::kNone) return Reason::kNone;
  const double c = in.sample.celsius;
  age_ = in.now - in.sample.stamp;
  known_ = in.sample.present && age_ <= kLost && c >= kLowestC && c <= kHighestC;
  if (!known_) {
    arming_blocker_ = Reason::kThermometerLost;
    return arming_blocker_;
  }
  celsius_ = c;
  return role_ == ThermometerRole::kCoil ? check_coil(in, dt_s) : check_shell(dt_s);
}

Reason ThermometerCheck::check_shell(double dt_s) noexcept {
  const bool hot = celsius_ >= model::kShellTripC;
  arming_blocker_ = hot ? Reason::kShellHot : Reason::kNone;
  return hot_.step(hot, dt_s, kHotHoldS) ? Reason::kShellHot : Reason::kNone;
}

Reason ThermometerCheck::check_coil(const ThermometerReading& in, double dt_s) noexcept {
  if (in.sensor) {
    if (!following_) quick_c_ = slow_c_ = in.sensor_c;
    following_ = true;
    quick_c_ += (in.sensor_c - quick_c_) * std::min(1.0, dt_s / kQuickS);
    slow_c_ += (in.sensor_c - slow_c_) * std::min(1.0, dt_s / kSlowS);
  }
  const auto [low, high] = std::minmax(quick_c_, slow_c_);
  const bool apart = following_ && (celsius_ < low - kDisagreeK || celsius_ > high + kDisagreeK);
  const bool disagrees = disagrees_.step(apart, dt_s, kDisagreeHoldS);
  const bool hot = hot_.step(celsius_ >= in.trip_c, dt_s, kHotHoldS);
  arming_blocker_ = apart ? Reason::kThermometerDisagrees : Reason::kNone;
  if (hot) return Reason::kOverheated;
  return disagrees ? Reason::kThermometerDisagrees : Reason::kNone;
}

bool ThermometerCheck::too_warm_to_arm() const noexcept {
  return on_shell() && (!known_ || celsius_ > model::kShellZeroC);
}

}  // namespace hedgehog::control
