// SPDX-License-Identifier: MIT
#include "model/estimate/resistance_fall.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hedgehog::model {
namespace {

// Allowance of the CUSUM, standard deviations; higher where each winding has its own thermistor as
// a second check.
constexpr double kSlack = 0.4;
constexpr double kSlackBesideThermistor = 0.7;
constexpr double kMarginDecayS = 300.0;

}  // namespace

void ResistanceFall::add(double deviations, bool each_winding_has_a_thermistor) noexcept {
  const double slack = each_winding_has_a_thermistor ? kSlackBesideThermistor : kSlack;
  sum_ = std::max(0.0, sum_ - deviations - slack);
  margin_k_ = std::max(margin_k_, kMaxMarginK * std::min(1.0, sum_ / kLimit));
}

void ResistanceFall::age(double dt_s) noexcept { margin_k_ *= 1.0 - dt_s / kMarginDecayS; }

void ResistanceFall::follow(const WindingThermometer& winding, double offset_a) noexcept {
  const bool compared = std::exchange(comparing_, winding.comparing());
  if (winding.reference_taken())
    compare({winding.r25_ohm(), winding.reference_per_ampere()}, offset_a);
  else if (compared && !comparing_)
    resume();
  else if (!compared && comparing_)
    rest();
}

void ResistanceFall::rest() noexcept { suspended_sum_ += std::exchange(sum_, 0.0); }

void ResistanceFall::compare(const RestResistance& now, double offset_a) noexcept {
  const double by_offset = offset_a * std::abs(now.per_ampere - before_.per_ampere);
  const bool same = now.ohm >= (1.0 - tolerance_) * before_.ohm && by_offset <= kSameShare;
  if (suspended_sum_ > 0.0 && !same) return resume();
  suspended_sum_ = 0.0;
  // The reference never decreases: otherwise a fall that begins at rest, or continues by less than
  // the tolerance, would lower its own reference.
  if (by_file_ || now.ohm > before_.ohm) before_ = now;
  tolerance_ = kSameShare;
  by_file_ = false;
}

void ResistanceFall::resume() noexcept { sum_ += std::exchange(suspended_sum_, 0.0); }

}  // namespace hedgehog::model
