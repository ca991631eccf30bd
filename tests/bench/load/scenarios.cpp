// SPDX-License-Identifier: MIT
#include "tests/bench/load/scenarios.h"

#include <algorithm>

namespace hedgehog::bench {

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> kAll{
      {"ping", measure_ping},
      {"64 clients", measure_crowd},
      {"pipelined", measure_pipelined},
      {"effect.pulse", measure_pulse},
      {"lateness", measure_lateness},
      {"lateness under requests", measure_lateness_under_requests},
      {"lateness under stress", measure_lateness_under_stress},
      {"work of a tick", measure_tick_work},
      {"idle", measure_idle},
      {"subscribers", measure_subscribers},
      {"memory", measure_memory},
      {"start", measure_start},
      {"an hour of plant", measure_plant_hour},
      {"client library", measure_client},
  };
  return kAll;
}

void in_turn(int round, std::initializer_list<std::function<void()>> parts) {
  std::vector<std::function<void()>> order(parts);
  if (round % 2 != 0) std::reverse(order.begin(), order.end());
  for (const auto& part : order) part();
}

}  // namespace hedgehog::bench
