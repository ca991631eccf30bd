// SPDX-License-Identifier: MIT
// Cost of the characterisation of the thesis' tkD array on one core: the force curves of all its
// pins over 31 offsets. Budgets: 20 ms at an accuracy of 0.1 %, 150 ms at 1e-6. The direct
// computation, every pin with every other magnet, runs in the same process and prints the ratio.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "model/magnets/characterisation.h"
#include "model/magnets/equilibrium.h"

namespace hedgehog::model {
namespace {

const Arrangement& tkd() {
  static const Arrangement arrangement = arrangement_named("tkD").value();
  return arrangement;
}

/// Reports the budget with the measurement. Processor time, because the machine may be shared.
void check_budget(benchmark::State& state, std::clock_t spent, double budget_ms) {
  const auto runs = std::max<benchmark::IterationCount>(1, state.iterations());
  const double each_ms =
      1e3 * static_cast<double>(spent) / CLOCKS_PER_SEC / static_cast<double>(runs);
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.1f ms, budget %.0f ms %s", each_ms, budget_ms,
                each_ms <= budget_ms ? "kept" : "MISSED");
  state.SetLabel(text.data());
}

double accuracy_of(const benchmark::State& state) {
  return std::pow(10.0, -static_cast<double>(state.range(0)));
}

/// From the positions of the magnets: classes, curves, rests, minima.
void characterise_tkd(benchmark::State& state) {
  const ForceSettings settings{ForceModel::kExact, accuracy_of(state)};
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    const auto classes = symmetry_classes(tkd());
    benchmark::DoNotOptimize(characterise(classes, {}, settings));
  }
  check_budget(state, std::clock() - start, state.range(0) <= 3 ? 20.0 : 150.0);
}
BENCHMARK(characterise_tkd)->ArgName("digits")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);

/// The 31 offsets of all classes only, as in the table of costs of physics.md section 8.
void curves_of_tkd(benchmark::State& state) {
  const ForceSettings settings{ForceModel::kExact, accuracy_of(state)};
  const auto classes = symmetry_classes(tkd());
  for (auto _ : state)
    for (const PinClass& pin_class : classes)
      benchmark::DoNotOptimize(force_curve({pin_class, {}, settings}));
}
BENCHMARK(curves_of_tkd)->ArgName("digits")->Arg(3)->Arg(6)->Unit(benchmark::kMillisecond);

/// Every pin with each of its 271 others at every offset, nothing merged; `ratio`: duration
/// relative to the curves by classes.
void naive_tkd(benchmark::State& state) {
  const ForceSettings settings{ForceModel::kExact, accuracy_of(state)};
  const ArraySizes sizes;
  const auto classes = symmetry_classes(tkd());
  const auto offsets = kThesisGrid.offsets_mm();
  // Processor time, and several runs of short computations, because the machine may be shared.
  constexpr int kRuns = 10;
  std::clock_t naive = 0;
  std::clock_t by_class = 0;
  for (auto _ : state) {
    const std::clock_t start = std::clock();
    for (const MagnetSite& pin : tkd().pins) {
      for (const double offset : offsets) {
        double sum_n = 0.0;
        for (const MagnetSite& other : tkd().pins) {
          if (other.id == pin.id) continue;
          const PairPlace place{angle_deg(pin.direction, other.direction), offset, 0.0};
          sum_n += pair_force(sizes.pin_and_pin(), place, settings).force_n;
        }
        for (const MagnetSite& other : tkd().shields) {
          const PairPlace place{angle_deg(pin.direction, other.direction), offset, 0.0};
          sum_n -= pair_force(sizes.pin_and_shield(), place, settings).force_n;
        }
        benchmark::DoNotOptimize(sum_n);
      }
    }
    const std::clock_t middle = std::clock();
    for (int run = 0; run < kRuns; ++run)
      for (const PinClass& pin_class : classes)
        benchmark::DoNotOptimize(force_curve({pin_class, sizes, settings}));
    naive += middle - start;
    by_class += std::clock() - middle;
  }
  state.counters["ratio"] = static_cast<double>(kRuns * naive) / static_cast<double>(by_class);
}
BENCHMARK(naive_tkd)->ArgName("digits")->Arg(3)->Arg(6)->Iterations(1)->Unit(
    benchmark::kMillisecond);

void one_pair(benchmark::State& state) {
  const ForceSettings settings{ForceModel::kExact, accuracy_of(state)};
  double offset_mm = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(pair_force({}, {12.0, offset_mm, 0.0}, settings));
    offset_mm = offset_mm > 10.0 ? 0.0 : offset_mm + 0.1;
  }
}
BENCHMARK(one_pair)->ArgName("digits")->Arg(3)->Arg(6)->Arg(9);

void equilibrium_of_tkd(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(find_equilibrium(tkd(), {}, {ForceModel::kExact, 1e-6}));
}
BENCHMARK(equilibrium_of_tkd)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hedgehog::model
