// SPDX-License-Identifier: MIT
#include "model/estimate/resistance_fall.h"

#include <algorithm>

namespace hedgehog::model {
namespace {

// What a deviation has to exceed to count. Where each winding has a thermistor, that judges it too.
constexpr double kSlack = 0.4;
constexpr double kSlackBesideThermistor = 0.7;
constexpr double kMarginDecayS = 300.0;

}  // namespace

void ResistanceFall::add(double deviations, bool each_winding_has_a_thermistor) noexcept {
  const double slack = each_winding_has_a_thermistor ? kSlackBesideThermistor : kSlack;
  sum_ = std::max(0.0, sum_ - deviations - slack);
  margin_k_ = std::max(margin_k_, kMaxMarginK * std::min(1.0, sum_ / kLimit));
}

void ResistanceFall::age(double dt_s) noexcept {
  margin_k_ *= 1.0 - std::min(1.0, dt_s / kMarginDecayS);
}

}  // namespace hedgehog::model
