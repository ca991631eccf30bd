// SPDX-License-Identifier: MIT
// Cost of the limiter per tick: cool, derated, and with windings that have not been measured.
#include <benchmark/benchmark.h>

#include "model/limit/thermal_limiter.h"

namespace hedgehog::model {
namespace {

void limit(benchmark::State& state, double hottest_c, bool measured) {
  ThermalLimiter limiter;
  ThermalEstimate estimate;
  estimate.hottest_c = hottest_c;
  estimate.measured.fill(measured);
  const CoilCurrents requested{{5.0, 6.0, 7.0}};
  for (auto _ : state) benchmark::DoNotOptimize(limiter.limit(requested, estimate));
}
BENCHMARK_CAPTURE(limit, cool, 25.0, true);
BENCHMARK_CAPTURE(limit, derated, 65.0, true);
BENCHMARK_CAPTURE(limit, unmeasured, 25.0, false);

}  // namespace
}  // namespace hedgehog::model
