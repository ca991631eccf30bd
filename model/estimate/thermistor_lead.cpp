// SPDX-License-Identifier: MIT
#include "model/estimate/thermistor_lead.h"

namespace hedgehog::model {
namespace {

constexpr double kFastS = 0.25;
constexpr double kSlowS = 1.0;
constexpr double kLeadS = 2.0;

}  // namespace

void ThermistorLead::step(bool valid, double shown_c, double dt_s) noexcept {
  if (!valid) {
    invalid_s_ += dt_s;
    return;
  }
  if (!read_ || lost()) fast_c_ = slow_c_ = shown_c;
  read_ = true;
  invalid_s_ = 0.0;
  fast_c_ += (shown_c - fast_c_) * dt_s / kFastS;
  slow_c_ += (fast_c_ - slow_c_) * dt_s / kSlowS;
  const double slope_k_s = (fast_c_ - slow_c_) / kSlowS;
  celsius_ = fast_c_ + (kLeadS + kFastS) * slope_k_s;
}

}  // namespace hedgehog::model
