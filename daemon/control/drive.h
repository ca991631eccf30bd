// SPDX-License-Identifier: MIT
// From mixed effects to a set-point: limit, gate, drive; for the control thread and the preview.
#pragma once

#include "daemon/control/current_prediction.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/limit/thermal_limiter.h"

namespace hedgehog::control {

/// Winding currents requested by `mix`, A, and their field; not limited.
model::CoilCurrents demanded_currents(const MixResult& mix, const model::CoilModel& coils) noexcept;
model::FieldDemand field_demand(const MixResult& mix, const model::CoilModel& coils) noexcept;

/// Limits `demand` by the windings' thermal state and the skin's upper bound. Call it every `dt_s`.
model::LimitedCurrents limit(model::ThermalLimiter& limiter, const model::CoilCurrents& demand,
                             const model::ThermalEstimate& thermal, double skin_c,
                             double dt_s) noexcept;

/// The watchdog's gate: zero unless armed.
constexpr model::LimitedCurrents gate(const model::LimitedCurrents& limited, bool armed) noexcept {
  return armed ? limited : model::LimitedCurrents();
}

/// The share of `demand` that was passed, 0..1; 1 when nothing was requested.
double delivered_share(const model::CoilCurrents& demand,
                       const model::LimitedCurrents& passed) noexcept;

/// The set-point that drives the currents from `now_a` to `passed`. Unless `playing` the bridges
/// sleep: duty 0 alone would brake and keep them awake.
device::BoardCommand drive(const model::LimitedCurrents& passed, bool playing,
                           const model::Vec3& now_a, const WindingCircuit& circuit) noexcept;

}  // namespace hedgehog::control
