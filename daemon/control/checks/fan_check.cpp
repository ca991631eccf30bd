// SPDX-License-Identifier: MIT
#include "daemon/control/checks/fan_check.h"

#include <algorithm>

namespace hedgehog::control {

Reason FanCheck::step(bool commanded, double rpm, double dt_s) noexcept {
  const bool stalled = commanded && !(rpm >= kMinRpm);
  if (!stalled) stalled_.reset();  // one turn proves that it is not seized
  due_ = stalled_.step(stalled, dt_s, kHoldS);
  return due_ ? Reason::kFanStopped : Reason::kNone;
}

void FanCheck::reset() noexcept {
  stalled_.reset();
  due_ = false;
}

bool FanCheck::cooling() const noexcept { return cooling_s_ >= kCoolingHoldS; }

void FanCheck::follow(const FanReading& reading, double dt_s) noexcept {
  age_s_ = reading.fresh ? 0.0 : age_s_ + dt_s;
  if (age_s_ > kMaxAgeS) cooling_s_ = 0.0;
  if (!reading.fresh) return;
  const bool driven = reading.duty >= kMinCoolingDuty;
  const bool turns =
      reading.rpm >= kMinCoolingShare * full_rpm_ && reading.rpm <= kMaxCoolingShare * full_rpm_;
  cooling_s_ = driven && turns ? std::min(cooling_s_ + dt_s, kCoolingHoldS) : 0.0;
  failing_s_ = driven && !turns ? std::min(failing_s_ + dt_s, kMaxStartS) : 0.0;
  if (cooling()) works_ = true;
  if (failing_s_ >= kMaxStartS) works_ = false;
}

}  // namespace hedgehog::control
