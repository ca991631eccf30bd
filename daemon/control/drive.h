// SPDX-License-Identifier: MIT
// From the mixed effects to a set-point: limit, gate, drive. Used by the control thread and by the
// preview.
#pragma once

#include "daemon/control/current_prediction.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/limit/thermal_limiter.h"

namespace hedgehog::control {

/// Winding currents requested by `mix`, A, and the field they correspond to; not limited.
model::CoilCurrents demanded_currents(const MixResult& mix, const model::CoilModel& coils) noexcept;
model::FieldDemand field_demand(const MixResult& mix, const model::CoilModel& coils) noexcept;

/// `demand`, limited by the windings' thermal state `thermal` and by the skin's upper bound
/// `skin_c`. Call it once every `dt_s`, like `ThermalLimiter::limit`.
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

/// The set-point that drives the currents from `now_a` to `passed`. Without a `playing` effect the
/// bridges sleep: duty 0 alone would brake and keep them awake.
device::BoardCommand drive(const model::LimitedCurrents& passed, bool playing,
                           const model::Vec3& now_a, const WindingCircuit& circuit) noexcept;

}  // namespace hedgehog::control
