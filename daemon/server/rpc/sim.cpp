// SPDX-License-Identifier: MIT
// sim.*
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "daemon/server/device/sim_faults.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

using protocol::RpcError;

RpcError not_simulated(const char* method) {
  return protocol::error(protocol::ErrorCode::kUnsupported,
                         std::string(method) + ": this daemon drives a real ball");
}

protocol::SimResult sim_result(const device::SimulatorSettings& settings) {
  protocol::SimResult result{
      settings.ambient_c, sim_fault_names(settings.faults), settings.coil, {}};
  for (std::size_t i = 0; i < settings.errors.count; ++i) {
    const device::SimulatorError& error = settings.errors.error[i];
    protocol::SimError shown{std::string(device::name(error.kind)), {}, error.value, error.ramp_s};
    if (device::range_of(error.kind).of_winding) shown.coil = error.coil;
    result.errors.push_back(std::move(shown));
  }
  return result;
}

std::optional<RpcError> set_faults(const protocol::SimFault& fault,
                                   device::SimulatorSettings& settings) {
  settings.faults = 0;
  for (const std::string& name : fault.faults) {
    const auto bit = sim_fault_named(name);
    if (!bit) {
      RpcError e = protocol::invalid_params("fault", "there is no fault '" + name + "'");
      e.value = name;
      return e;
    }
    settings.faults = static_cast<std::uint16_t>(settings.faults | *bit);
  }
  settings.coil = static_cast<std::uint8_t>(fault.coil);
  return std::nullopt;
}

std::optional<RpcError> set_error(const protocol::SimError& asked, std::size_t index,
                                  device::SimulatorErrorList& list) {
  const std::string field = "errors[" + std::to_string(index) + "].";
  const auto kind = device::simulator_error_kind(asked.kind);
  if (!kind) {
    RpcError e = protocol::invalid_params(field + "kind", "there is no error '" + asked.kind + "'");
    e.value = asked.kind;
    return e;
  }
  const device::SimulatorErrorRange range = device::range_of(*kind);
  if (!(asked.value >= range.min))
    return protocol::out_of_range(field + "value", range.min, asked.value);
  if (!(asked.value <= range.max))
    return protocol::out_of_range(field + "value", range.max, asked.value);
  // An error of the whole ball has no winding.
  const std::int64_t coil = range.of_winding ? asked.coil.value_or(0) : 0;
  list.error[list.count++] = {*kind, static_cast<std::uint8_t>(coil), asked.value, asked.ramp_s};
  return std::nullopt;
}

std::optional<RpcError> set_errors(const std::vector<protocol::SimError>& errors,
                                   device::SimulatorSettings& settings) {
  static_assert(protocol::kMaxSimErrors == device::SimulatorErrorList::kMaxErrors);
  device::SimulatorErrorList list;
  list.generation = static_cast<std::uint8_t>(settings.errors.generation + 1);
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (auto refused = set_error(errors[i], i, list)) return refused;
  settings.errors = list;
  return std::nullopt;
}

protocol::SimTruthResult truth_result(const device::PlantTruth& truth) {
  protocol::SimTruthResult result;
  result.coils_c.assign(truth.coils_c.begin(), truth.coils_c.end());
  result.core_c = truth.core_c;
  result.skin_c = truth.skin_c;
  result.current_a = {truth.current_a.x, truth.current_a.y, truth.current_a.z};
  result.ambient_c = truth.ambient_c;
  return result;
}

}  // namespace

Outcome handle(Call& call, const protocol::SimSet& request) {
  DeviceView& device_view = call.device_view();
  if (!device_view.simulated()) return Response(not_simulated("sim.set"));
  device::SimulatorSettings settings = device_view.simulator();
  settings.ambient_c = request.ambient_c.value_or(settings.ambient_c);
  if (request.fault) {
    if (auto refused = set_faults(*request.fault, settings)) return Response(*std::move(refused));
  }
  if (request.errors) {
    if (auto refused = set_errors(*request.errors, settings)) return Response(*std::move(refused));
  }
  if (request.orientation && device_view.config().imu != config::ImuType::kSimulator) {
    return Response(protocol::error(protocol::ErrorCode::kUnsupported,
                                    "orientation: the sensor is not simulated here"));
  }
  if (request.orientation) device_view.set_orientation(*request.orientation);
  if (settings != device_view.simulator()) device_view.set_simulator(settings);
  return Response(sim_result(device_view.simulator()));
}

Outcome handle(Call& call, const protocol::SimTruth&) {
  DeviceView& device_view = call.device_view();
  if (!device_view.simulated()) return Response(not_simulated("sim.truth"));
  if (device_view.truth().known) return Response(truth_result(device_view.truth()));
  return Deferred{[](HandlerContext& context, bool give_up) -> std::optional<Response> {
    const device::PlantTruth& truth = context.device_view.truth();
    if (truth.known) return Response(truth_result(truth));
    return give_up ? std::optional<Response>(
                         protocol::busy("the simulated board does not respond", 1000))
                   : std::nullopt;
  }};
}

}  // namespace hedgehog::server
