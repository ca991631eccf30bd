// SPDX-License-Identifier: MIT
#include "daemon/control/checks/current_check.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::control {
namespace {

using model::kTickSeconds;

// Mid-range winding temperature in use; R differs by +-10 % between 0 and 75 C.
constexpr model::Celsius kTypical{40.0};
// Time after an edge in which a difference is tolerated: L/R is 3.3 ms, set-points take up to 5 ms.
constexpr double kEdgeS = 0.01;
constexpr double kIdleEdgeS = 0.005;
// The link sends the safe command after 20 ticks without a set-point; after 100 no current flows.
constexpr model::Tick kLinkHolds = 19;
constexpr model::Tick kMaxSkippedTicks = 100;
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

bool CurrentCheck::pending() const noexcept {
  return std::any_of(
      windings_.begin(), windings_.end(),
      [](const Winding& w) {
        return w.unexpected.pending() || w.mismatch.pending() || w.odd.pending();
      });
}

// The tick of a gap in which the board put its bridges to sleep is unknown, so all of it is treated
// as an edge.
void CurrentCheck::advance_skipped(const CurrentReading& reading) noexcept {
  const model::Tick ticks = std::min(reading.skipped, kMaxSkippedTicks);
  for (int coil = 0; coil < model::kCoils; ++coil) {
    Winding& w = windings_[static_cast<std::size_t>(coil)];
    double& commanded = commanded_a_[coil];
    for (model::Tick i = 0; i < ticks; ++i) {
      const double volts = i < kLinkHolds ? reading.held_v[coil] : 0.0;
      commanded = w.keep * commanded + (1.0 - w.keep) * w.conductance_s * volts;
      w.low_a = std::min(w.low_a, commanded);
      w.high_a = std::max(w.high_a, commanded);
      w.idle_peak_a = std::max(w.idle_peak_a, std::abs(commanded));
    }
  }
}

Reason CurrentCheck::check(int coil, const CurrentReading& reading) noexcept {
  Winding& w = windings_[static_cast<std::size_t>(coil)];
  const bool known = reading.measured[static_cast<std::size_t>(coil)];
  const bool by_duty = reading.follows && by_duty_known_;
  if (by_duty)
    w.by_duty_a = w.keep * w.by_duty_a + (1.0 - w.keep) * w.conductance_s * reading.applied_v[coil];
  else
    w.by_duty_a = known ? reading.current_a[coil] : commanded_a_[coil];
  w.peak_a = std::max(std::abs(w.by_duty_a), kEdgeKeep * w.peak_a);
  if (!known) {
    // Evidence neither for nor against a fault; sleeping bridges leave the current unknown for
    // long.
    for (FaultDebounce* debounce : {&w.unexpected, &w.mismatch, &w.odd})
      debounce->step(false, reading.since_s, kHoldS);
    return Reason::kNone;
  }
  const double measured = reading.current_a[coil];
  const bool idle = w.idle_peak_a < 0.5 * kIdleA;
  const bool unexpected = idle && std::abs(measured) > kIdleA + w.idle_peak_a;
  const double slack = kOffsetA + kShare * std::max(std::abs(w.low_a), std::abs(w.high_a));
  const bool beyond = measured < w.low_a - slack || measured > w.high_a + slack;
  const bool odd = std::abs(measured - w.by_duty_a) > kOffsetA + kShare * w.peak_a;

  const bool driven = w.unexpected.step(unexpected, reading.since_s, kHoldS);
  bool mismatch = w.mismatch.step(!idle && (beyond || odd), reading.since_s, kHoldS);
  if (by_duty) mismatch |= w.odd.step(!idle && odd, kTickSeconds, kHoldS);
  if (driven) return Reason::kUnexpectedCurrent;
  return mismatch ? Reason::kCurrentMismatch : Reason::kNone;
}

Reason CurrentCheck::step(const CurrentReading& reading) noexcept {
  Reason trip = Reason::kNone;
  advance_skipped(reading);
  for (int coil = 0; coil < model::kCoils; ++coil) {
    if (reading.fresh) {
      const Reason found = check(coil, reading);
      if (trip == Reason::kNone || found == Reason::kUnexpectedCurrent) trip = found;
    }
    Winding& w = windings_[static_cast<std::size_t>(coil)];
    double& commanded = commanded_a_[coil];
    const double target = w.conductance_s * reading.commanded_v[coil];
    commanded = w.keep * commanded + (1.0 - w.keep) * target;
    w.low_a = std::min(commanded, commanded + kEdgeKeep * (w.low_a - commanded));
    w.high_a = std::max(commanded, commanded + kEdgeKeep * (w.high_a - commanded));
    w.idle_peak_a = std::max(std::abs(commanded), kIdleKeep * w.idle_peak_a);
  }
  by_duty_known_ |= reading.fresh;
  return trip;
}

}  // namespace hedgehog::control
