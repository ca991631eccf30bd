// SPDX-License-Identifier: MIT
// Cost of one control tick of an armed ball with an active push: reading of the board, watchdog,
// estimate, mixer, limiter and command, without the simulated ball. A tick has 1000 us. Ten ticks
// per second also process the filter's measurements: the most expensive ones.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "daemon/control/loop/control_tick.h"
#include "daemon/device/simulator/lock_step.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

void tick(benchmark::State& state) {
  auto mailbox = std::make_unique<Mailbox>();
  auto port = std::make_unique<device::LinkPort>();
  ControlTick control(rig::RigOptions::armed_at_start(), *mailbox, *port, nullptr);
  device::LockStep world(*port);
  Event event;
  model::Tick now = 0;
  const auto one = [&] {
    const auto from = std::chrono::steady_clock::now();
    control.run(++now, 0, {});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
    world.step();
    while (mailbox->events.pop(event)) {
    }
    return took.count();
  };
  for (int i = 0; i < 500; ++i) one();
  StartEffect start{1, 0, 1, 0, {}};
  start.spec = rig::hold({1, 2, 3}, 5.0);
  mailbox->commands.push({1, start});
  std::vector<double> costs;
  for (auto _ : state) {
    const double took_s = one();
    state.SetIterationTime(took_s);
    costs.push_back(took_s);
  }
  std::sort(costs.begin(), costs.end());
  state.counters["p99_us"] = 1e6 * costs[costs.size() * 99 / 100];
  if (mailbox->status.read().state != State::kArmed) state.SkipWithError("not armed");
}
BENCHMARK(tick)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hedgehog::control
