// SPDX-License-Identifier: MIT
// The search for a better ball as `hedgehog-design choose` does it with default options: 11 767
// designs. Budget: one minute, measured in processor time because the machine may be shared; the
// counter reports designs per second.
#include <benchmark/benchmark.h>

#include <ctime>
#include <thread>

#include "clients/design/search/search.h"

namespace hedgehog::design {
namespace {

constexpr double kBudgetS = 60.0;

SearchSpace usual_space() {
  SearchSpace space{
      {"GP(1,1)", "cD", "wD", "tkD", "GP(2,2)", "GP(3,1)", "GP(4,0)"}, {{8.0, 10.0}}, {}, {}, {}};
  for (int i = 0; i <= 40; ++i) {
    space.shields.push_back({3.0 + 0.05 * i, 10.0});
    space.spheres_mm.push_back(35.0 + 0.25 * i);
  }
  return space;
}

void choose(benchmark::State& state) {
  const auto search = Search::in(usual_space(), Demands{}).value();
  std::size_t looked_at = 0;
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    const auto outcome = search.run(static_cast<int>(state.range(0)), [](std::size_t) {});
    looked_at += outcome.looked_at;
    benchmark::DoNotOptimize(outcome.front.data());
  }
  state.counters["designs/s"] =
      benchmark::Counter(static_cast<double>(looked_at), benchmark::Counter::kIsRate);
  const double took_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const bool in_budget = took_s <= kBudgetS && looked_at >= 10'000;
  state.SetLabel(in_budget ? "budget of a minute kept" : "budget of a minute MISSED");
  state.counters["designs"] = static_cast<double>(search.space().size());
}
BENCHMARK(choose)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Iterations(1);

}  // namespace
}  // namespace hedgehog::design
