// SPDX-License-Identifier: MIT
// The scenarios of a round: each starts its programs, loads them and adds its figures. A failed
// measurement throws std::runtime_error; what this machine cannot provide is left out.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <vector>

#include "tests/bench/load/figures.h"
#include "tests/bench/load/setup.h"

namespace hedgehog::bench {

/// Clients of a crowd.
inline constexpr std::size_t kCrowd = 64;
/// Share of a measurement's duration that runs before it as a warm-up.
inline constexpr double kWarmUpShare = 0.2;

// Requests (request_scenarios.cpp, pulse_scenario.cpp, subscriber_scenario.cpp).
void measure_ping(const Setup& setup, Figures& figures);
void measure_crowd(const Setup& setup, Figures& figures);
void measure_pipelined(const Setup& setup, Figures& figures);
void measure_pulse(const Setup& setup, Figures& figures);
void measure_subscribers(const Setup& setup, Figures& figures);

// The control loop (loop_scenarios.cpp).
void measure_lateness(const Setup& setup, Figures& figures);
void measure_lateness_under_requests(const Setup& setup, Figures& figures);
void measure_lateness_under_stress(const Setup& setup, Figures& figures);
void measure_tick_work(const Setup& setup, Figures& figures);
void measure_idle(const Setup& setup, Figures& figures);

// Programs as a whole (program_scenarios.cpp).
void measure_memory(const Setup& setup, Figures& figures);
void measure_start(const Setup& setup, Figures& figures);
void measure_plant_hour(const Setup& setup, Figures& figures);
void measure_client(const Setup& setup, Figures& figures);

struct Scenario {
  const char* name;
  void (*measure)(const Setup& setup, Figures& figures);
};
const std::vector<Scenario>& scenarios();

/// In the given order in even rounds, in reverse order in odd ones.
void in_turn(int round, std::initializer_list<std::function<void()>> parts);

}  // namespace hedgehog::bench
