// SPDX-License-Identifier: MIT
// The way from the mixed effects to a set-point: limit, gate, drive. The control thread and the
// preview take the same.
#pragma once

#include "daemon/control/current_prediction.h"
#include "daemon/control/effects/mixer.h"
#include "daemon/device/board_io.h"
#include "model/coils.h"
#include "model/limit/thermal_limiter.h"

namespace hedgehog::control {

/// What `mix` asks of the windings, A, and the field that it asks for with them; not limited.
model::CoilCurrents wanted_currents(const MixResult& mix, const model::CoilModel& coils) noexcept;
model::FieldDemand wanted_field(const MixResult& mix, const model::CoilModel& coils) noexcept;

/// `wanted` as far as the windings' heat, `thermal`, and the skin, at most `skin_c`, allow. Call it
/// once every `dt_s`, as `ThermalLimiter::limit`.
model::LimitedCurrents limit(model::ThermalLimiter& limiter, const model::CoilCurrents& wanted,
                             const model::ThermalEstimate& thermal, double skin_c,
                             double dt_s) noexcept;

/// The watchdog's gate: zero unless armed.
constexpr model::LimitedCurrents gate(const model::LimitedCurrents& limited, bool armed) noexcept {
  return armed ? limited : model::LimitedCurrents();
}

/// The share of `wanted` that has passed, 0..1; 1 when nothing was asked.
double passed_share(const model::CoilCurrents& wanted,
                    const model::LimitedCurrents& passed) noexcept;

/// The set-point that brings `passed` about from `now_a`, what flows now. Without a `playing`
/// effect the bridges sleep: duty 0 alone would be a brake that keeps them awake.
device::BoardCommand drive(const model::LimitedCurrents& passed, bool playing,
                           const model::Vec3& now_a, const WindingCircuit& circuit) noexcept;

}  // namespace hedgehog::control
