// SPDX-License-Identifier: MIT
#include "daemon/control/current_check.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

// The middle of what a winding may be while it is in use; +-10 % to 0 and 75 C.
constexpr model::Celsius kTypical{40.0};
// How long an edge excuses a difference: L/R is 3.3 ms, set-points are up to 5 ms on their way.
constexpr double kEdgeS = 0.01;
constexpr double kIdleEdgeS = 0.005;
const double kEdgeKeep = std::exp(-kTickSeconds / kEdgeS);
const double kIdleKeep = std::exp(-kTickSeconds / kIdleEdgeS);

}  // namespace

CurrentCheck::CurrentCheck(const model::CoilModel& coils) noexcept {
  for (std::size_t i = 0; i < model::kCoils; ++i) {
    const double r = resistance_at(model::Ohms(coils.r25_ohm[i]), kTypical).value;
    windings_[i].conductance_s = 1.0 / r;
    windings_[i].keep = std::exp(-r * kTickSeconds / coils.inductance_h);
  }
}

bool CurrentCheck::suspicious() const noexcept {
  return std::any_of(windings_.begin(), windings_.end(), [](const Winding& w) {
    return w.unexpected.suspicious() || w.mismatch.suspicious();
  });
}

Reason CurrentCheck::step(const CurrentReading& reading) noexcept {
  Reason trip = Reason::kNone;
  if (!reading.consecutive) by_duty_known_ = false;
  for (int coil = 0; coil < model::kCoils; ++coil) {
    Winding& w = windings_[static_cast<std::size_t>(coil)];
    double& commanded = commanded_a_[coil];
    const double measured = reading.current_a[coil];
    if (reading.consecutive) {
      const bool idle = w.idle_peak_a < 0.5 * kIdleA;
      const bool unexpected = std::abs(measured) > kIdleA + w.idle_peak_a;
      const double slack = kOffsetA + kShare * std::max(std::abs(w.low_a), std::abs(w.high_a));
      const bool beyond = measured < w.low_a - slack || measured > w.high_a + slack;
      if (by_duty_known_) {
        w.by_duty_a =
            w.keep * w.by_duty_a + (1.0 - w.keep) * w.conductance_s * reading.applied_v[coil];
      } else {
        w.by_duty_a = measured;
      }
      w.peak_a = std::max(std::abs(w.by_duty_a), kEdgeKeep * w.peak_a);
      const bool odd = std::abs(measured - w.by_duty_a) > kOffsetA + kShare * w.peak_a;

      if (w.unexpected.step(idle && unexpected, kTickSeconds, kHoldS)) {
        trip = Reason::kUnexpectedCurrent;
      }
      if (w.mismatch.step(!idle && (beyond || odd), kTickSeconds, kHoldS) &&
          trip == Reason::kNone) {
        trip = Reason::kCurrentMismatch;
      }
    }
    const double target = w.conductance_s * reading.commanded_v[coil];
    commanded = w.keep * commanded + (1.0 - w.keep) * target;
    w.low_a = std::min(commanded, commanded + kEdgeKeep * (w.low_a - commanded));
    w.high_a = std::max(commanded, commanded + kEdgeKeep * (w.high_a - commanded));
    w.idle_peak_a = std::max(std::abs(commanded), kIdleKeep * w.idle_peak_a);
  }
  if (reading.consecutive) by_duty_known_ = true;
  return trip;
}

}  // namespace hedgehog::control
