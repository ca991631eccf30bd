// SPDX-License-Identifier: MIT
#include "daemon/config/keys/sensor_keys.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hedgehog::config {

using namespace keys;

namespace {

using D = Draft;
using device::SensorDriver;
using device::SensorJob;
using device::Side;
using device::ThermometerRole;

constexpr Choices<Side, 6> kSides{{{"front", Side::kFront},
                                   {"back", Side::kBack},
                                   {"left", Side::kLeft},
                                   {"right", Side::kRight},
                                   {"up", Side::kUp},
                                   {"down", Side::kDown}}};
constexpr Choices<ThermometerRole, 3> kRoles{{{"none", ThermometerRole::kNone},
                                              {"coil", ThermometerRole::kCoil},
                                              {"shell", ThermometerRole::kShell}}};

/// Adds the types of all usable drivers for `job` to `known`.
template <class Meaning>
std::vector<std::pair<std::string_view, Meaning>> with_drivers(
    std::vector<std::pair<std::string_view, Meaning>> known, SensorJob job) {
  for (const SensorDriver* driver : device::sensor_drivers())
    if (driver->job == job && driver->unusable.empty())
      known.emplace_back(driver->type, Meaning{driver});
  return known;
}

}  // namespace

std::string_view name(const ImuSource& source) noexcept {
  switch (source.type) {
    case ImuType::kSimulator:
      return "simulator";
    case ImuType::kExternal:
      return "external";
    case ImuType::kSensor:
      return source.driver->type;
    case ImuType::kNone:
      break;
  }
  return "none";
}

void add_sensor_keys(std::vector<Key<D>>& keys) {
  keys.push_back(choice_key<D>(
      "imu.type",
      with_drivers<std::optional<ImuSource>>({{"auto", std::nullopt},
                                              {"none", ImuType::kNone},
                                              {"simulator", ImuType::kSimulator},
                                              {"external", ImuType::kExternal}},
                                             SensorJob::kOrientation),
      [](auto& d) -> auto& { return d.imu; }));
  keys.push_back(serial_key<D>(
      "imu.serial", [](auto& d) -> auto& { return d.config.imu_fitting.serial; }));
  keys.push_back(choice_key<D>(
      "imu.front", kSides, [](auto& d) -> auto& { return d.config.imu_fitting.front; }));
  keys.push_back(choice_key<D>(
      "imu.up", kSides, [](auto& d) -> auto& { return d.config.imu_fitting.up; }));
  keys.push_back(choice_key<D>(
      "thermometer.type",
      with_drivers<const SensorDriver*>({{"none", nullptr}}, SensorJob::kThermometer),
      [](auto& d) -> auto& { return d.config.thermometer.driver; }));
  keys.push_back(choice_key<D>(
      "thermometer.role", kRoles, [](auto& d) -> auto& { return d.config.thermometer.role; }));
  keys.push_back(serial_key<D>(
      "thermometer.serial", [](auto& d) -> auto& { return d.config.thermometer.serial; }));
}

void resolve_sensors(Draft& draft, const Origins& origins, const std::string& file,
                     FileErrors& errors) {
  Config& config = draft.config;
  const auto wrong = [&](const std::string& key, const std::string& why) {
    errors.push_back(error_at(origins, key, why, file));
  };
  const bool simulator = config.backend == Backend::kSimulator;
  config.imu = draft.imu.value_or(simulator ? ImuType::kSimulator : ImuType::kNone);
  if (!simulator && config.imu == ImuType::kSimulator)
    wrong("imu.type", "\"simulator\" goes with backend \"simulator\" only");
  if (!device::Mounting::of(config.imu_fitting.front, config.imu_fitting.up))
    wrong("imu.up", "must be neither the side of imu.front nor the opposite one");
  ThermometerSettings& thermometer = config.thermometer;
  const bool fitted = thermometer.driver != nullptr;
  if (fitted && thermometer.role == ThermometerRole::kNone)
    wrong("thermometer.role", "must be \"coil\" or \"shell\" when there is a thermometer");
  if (!fitted && thermometer.role != ThermometerRole::kNone)
    wrong("thermometer.role", "needs a thermometer: thermometer.type is \"none\"");
  // A real thermometer does not measure a simulated coil.
  if (simulator && thermometer.role == ThermometerRole::kCoil) thermometer = {};
}

}  // namespace hedgehog::config
