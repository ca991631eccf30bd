// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "daemon/daemon.h"
#include "model/thermal/thermal_decay.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::daemon {

StartState start_state(const config::Config& config, const std::optional<server::SavedState>& saved,
                       const server::BootTime& now) {
  const bool simulated = config.backend == config::Backend::kSimulator;
  StartState start;
  control::ControlSettings& s = start.settings;
  s.coils = config.device.coils;
  s.thermal = config.device.thermal;
  s.uncertainty = config.device.uncertainty;
  s.thermometer = config.thermometer.role;
  s.limits = config.limits;
  s.ceiling = config.device.limits;
  s.gain = saved && saved->gain ? *saved->gain : config.gain;
  s.latch = saved ? saved->latch : control::Reason::kNone;
  if (saved) s.rearms = saved->rearms;
  const bool clean = saved && saved->clean_stop;
  s.arm_at_start =
      simulated || (config.arm_at_start == config::ArmAtStart::kAfterCleanStop && clean);
  if (simulated) s.start_timeout = std::numeric_limits<model::Tick>::max();
  s.start_reason = saved && !clean && config.arm_at_start == config::ArmAtStart::kAfterCleanStop
                       ? control::Reason::kUncleanStop
                       : control::Reason::kNeverArmed;

  start.simulated_c = config.simulator.ambient_c;
  if (simulated && (config.simulator.start_temperature_c || !saved)) {
    // The temperature of a ball started at this value is known without a measurement.
    start.simulated_c = config.simulator.start_temperature_c.value_or(config.simulator.ambient_c);
    s.start_known = true;
    s.start_measured.fill(true);
    s.start.winding_c.fill(start.simulated_c);
    s.start.core_c = start.simulated_c;
    s.start_ambient_c = config.simulator.ambient_c;
  } else if (saved && saved->heat_known) {
    s.start_known = true;
    s.start_measured = saved->measured;
    s.start = model::decayed(config.device.thermal, saved->heat, saved->ambient_c,
                             server::seconds_between(saved->saved_at, now));
    // Standard deviation of a uniform distribution within the bound: 1/sqrt(3), rounded up.
    constexpr double kDeviationOfBound = 0.6;
    const double cooled_k = model::hottest_winding(saved->heat) - model::hottest_winding(s.start);
    s.start_deviation_k += kDeviationOfBound * s.uncertainty.thermal * std::max(0.0, cooled_k);
    s.start_ambient_c = saved->ambient_c;
    if (simulated) start.simulated_c = model::hottest_winding(s.start);
  }
  return start;
}

}  // namespace hedgehog::daemon
