// SPDX-License-Identifier: MIT
// thermal.forecast, orientation.*, sim.set
#include <string>
#include <utility>

#include "daemon/server/effect_plan.h"
#include "daemon/server/handlers.h"
#include "daemon/server/load.h"
#include "daemon/server/sim_faults.h"

namespace hedgehog::server {
namespace {

using protocol::RpcError;

Answer forecast_result(const Machine& machine, const model::Forecast& f, double peak_a) {
  const auto derating =
      machine.skin_reduces(peak_a) ? std::optional<double>(0.0) : f.seconds_to_derating;
  return protocol::ForecastResult{derating, f.seconds_to_limit, f.sustainable_a, f.recovery_s};
}

Answer forecast_of(const Machine& machine, const model::AskedCurrents& asked) {
  return forecast_result(machine, machine.forecaster().forecast(machine.forecast_start(), asked),
                         asked.peak_a);
}

Answer forecast_current(const Machine& machine, double current_a,
                        const std::optional<protocol::Direction>& direction) {
  if (current_a > machine.limits().current_a) {
    return protocol::out_of_range("current_a", machine.limits().current_a, current_a);
  }
  if (!direction) {
    return forecast_result(
        machine, machine.forecaster().forecast_worst_coil(machine.forecast_start(), current_a),
        current_a);
  }
  const auto towards = protocol::resolve(*direction, machine.array(), "direction");
  if (towards.has_error()) {
    return towards.error();
  }
  const model::CoilCurrents currents =
      model::currents_for({current_a * *towards}, machine.config().device.coils);
  return forecast_of(machine, model::AskedCurrents::constant(currents.a));
}

Answer forecast_spec(const Machine& machine, const model::EffectSpec& spec,
                     const KeyframeScore* score) {
  return forecast_of(
      machine,
      load_of(spec, score, machine.config().device.coils, machine.now().orientation).asked());
}

RpcError no_imu(std::string_view field) {
  return protocol::device_absent(field, "no orientation sensor is connected", "imu");
}

protocol::SimResult sim_result(const device::SimulatorSettings& settings) {
  return {settings.ambient_c, sim_fault_names(settings.faults), settings.coil};
}

}  // namespace

Outcome thermal_forecast(Call& call, const protocol::ThermalForecast& request) {
  const Machine& machine = call.machine();
  if (request.current_a) {
    return forecast_current(machine, *request.current_a, request.direction);
  }
  if (request.start) {
    const auto plan = plan_start(call, *request.start);
    return plan.has_error() ? Answer(plan.error())
                            : forecast_spec(machine, plan->spec, plan->score.get());
  }
  const control::EffectId number = request.effect.value_or(0);
  const Effect* effect = call.services.effects.any(number);
  return effect == nullptr ? Answer(protocol::no_such_effect(number))
                           : forecast_spec(machine, effect->spec, effect->score.get());
}

Outcome orientation_set(Call& call, const protocol::OrientationSet& request) {
  Services& services = call.services;
  if (call.machine().config().imu != config::ImuType::kExternal) {
    RpcError e = protocol::error(
        protocol::ErrorCode::kUnsupported,
        call.machine().config().imu == config::ImuType::kSimulator
            ? "orientation.set: the sensor is simulated; turn the ball with sim.set"
            : "orientation.set: needs \"imu\": {\"type\": \"external\"} in the configuration");
    return Answer(std::move(e));
  }
  if (services.orientation_feeder == 0) {
    services.orientation_feeder = call.session.id;
  }
  if (services.orientation_feeder != call.session.id) {
    return Answer(protocol::error(protocol::ErrorCode::kClaimed,
                                  "claimed: another client feeds the orientation"));
  }
  call.machine().set_orientation(request.quaternion);
  return Answer(protocol::Done{});
}

Outcome orientation_recenter(Call& call, const protocol::OrientationRecenter& request) {
  if (!call.machine().now().orientation_present) {
    return Answer(no_imu("orientation"));
  }
  const auto seq =
      call.machine().outbox().add(call.session.id, control::Recenter{request.azimuth_deg});
  if (!seq) {
    return Answer(queue_full(call.machine().outbox()));
  }
  return Deferred{[seq = *seq](Services& services, bool give_up) -> std::optional<Answer> {
    if (services.machine.now().applied_seq >= seq) {
      return Answer(protocol::RecenterResult{services.machine.now().yaw_offset_deg});
    }
    return give_up ? std::optional<Answer>(control_stuck()) : std::nullopt;
  }};
}

Outcome sim_set(Call& call, const protocol::SimSet& request) {
  Machine& machine = call.machine();
  if (!machine.simulated()) {
    return Answer(protocol::error(protocol::ErrorCode::kUnsupported,
                                  "sim.set: this daemon drives a real ball"));
  }
  device::SimulatorSettings settings = machine.simulator();
  if (request.ambient_c) {
    settings.ambient_c = *request.ambient_c;
  }
  if (request.fault) {
    settings.faults = 0;
    for (const std::string& name : request.fault->faults) {
      const auto bit = sim_fault_named(name);
      if (!bit) {
        RpcError e = protocol::invalid_params("fault", "there is no fault '" + name + "'");
        e.value = name;
        return Answer(std::move(e));
      }
      settings.faults = static_cast<std::uint16_t>(settings.faults | *bit);
    }
    settings.coil = static_cast<std::uint8_t>(request.fault->coil);
  }
  if (request.orientation && machine.config().imu != config::ImuType::kSimulator) {
    return Answer(protocol::error(protocol::ErrorCode::kUnsupported,
                                  "orientation: the sensor is not simulated here"));
  }
  if (request.orientation) {
    machine.set_orientation(*request.orientation);
  }
  if (request.ambient_c || request.fault) {
    machine.set_simulator(settings);
  }
  return Answer(sim_result(machine.simulator()));
}

}  // namespace hedgehog::server
