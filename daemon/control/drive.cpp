// SPDX-License-Identifier: MIT
#include "daemon/control/drive.h"

#include "model/limit/shell_limit.h"

namespace hedgehog::control {

model::CoilCurrents demanded_currents(const MixResult& mix,
                                      const model::CoilModel& coils) noexcept {
  return {currents_for(mix.field, coils).a + mix.coil_a};
}

model::FieldDemand field_demand(const MixResult& mix, const model::CoilModel& coils) noexcept {
  return {mix.field.a + field_of({mix.coil_a}, coils).a};
}

model::LimitedCurrents limit(model::ThermalLimiter& limiter, const model::CoilCurrents& demand,
                             const model::ThermalEstimate& thermal, double skin_c,
                             double dt_s) noexcept {
  limiter.set_ceiling(model::shell_allowed_current(limiter.limits(), skin_c));
  return limiter.limit(demand, thermal, dt_s);
}

double delivered_share(const model::CoilCurrents& demand,
                       const model::LimitedCurrents& passed) noexcept {
  const double requested_a = norm(demand.a);
  return requested_a > 0.0 ? norm(passed.a()) / requested_a : 1.0;
}

device::BoardCommand drive(const model::LimitedCurrents& passed, bool playing,
                           const model::Vec3& now_a, const WindingCircuit& circuit) noexcept {
  if (!playing) return {};
  return device::BoardCommand::drive(passed, circuit.resistance_ohm, circuit.inductance_h, now_a,
                                     circuit.supply_v);
}

}  // namespace hedgehog::control
