// SPDX-License-Identifier: MIT
// thermal.*
#include "daemon/server/effects/load.h"
#include "daemon/server/effects/planning.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

Response forecast_result(const DeviceView& device_view, const model::Forecast& f) {
  if (!device_view.temperature_known()) {
    protocol::ForecastResult unknown;
    unknown.seconds_to_derating = 0.0;
    unknown.temperature_known = false;
    return unknown;
  }
  return protocol::ForecastResult{f.seconds_to_derating, f.seconds_to_limit, f.sustainable_a,
                                  f.recovery_s, true};
}

Response forecast_of(const DeviceView& device_view, const model::RequestedCurrents& requested) {
  return forecast_result(
      device_view, device_view.forecaster().forecast(device_view.forecast_start(), requested));
}

Response forecast_current(const DeviceView& device_view, double current_a,
                          const std::optional<protocol::Direction>& direction) {
  if (current_a > device_view.limits().current_a)
    return protocol::out_of_range("current_a", device_view.limits().current_a, current_a);
  if (!direction) {
    return forecast_result(device_view, device_view.forecaster().forecast_worst_coil(
                                            device_view.forecast_start(), current_a));
  }
  const auto towards = protocol::resolve(*direction, device_view.array(), "direction");
  if (towards.has_error()) return towards.error();
  const model::CoilCurrents currents =
      model::currents_for({current_a * *towards}, device_view.config().device.coils);
  return forecast_of(device_view, model::RequestedCurrents::constant(currents.a));
}

Response forecast_spec(const DeviceView& device_view, const model::EffectSpec& spec,
                       const KeyframeTrack* track) {
  return forecast_of(device_view, load_of(spec, track, device_view.config().device.coils,
                                          device_view.now().orientation)
                                      .requested());
}

}  // namespace

Outcome handle(Call& call, const protocol::ThermalForecast& request) {
  const DeviceView& device_view = call.device_view();
  if (request.current_a)
    return forecast_current(device_view, *request.current_a, request.direction);
  if (request.start) {
    const auto plan = plan_start(call.plan_context(), *request.start);
    return plan.has_error() ? Response(plan.error())
                            : forecast_spec(device_view, plan->spec, plan->track.get());
  }
  const control::EffectId number = request.effect.value_or(0);
  const Effect* effect = call.context.effects.any(number);
  return effect == nullptr
             ? Response(protocol::no_such_effect(number))
             : forecast_spec(device_view, effect->plan.spec, effect->plan.track.get());
}

}  // namespace hedgehog::server
