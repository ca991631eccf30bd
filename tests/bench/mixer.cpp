// SPDX-License-Identifier: MIT
// Cost of one tick of the mixer: without effects, and with N gliding circles with a sine, the most
// expensive effect. Budget at 64: 8 us.
#include "daemon/control/effects/mixer.h"

#include <benchmark/benchmark.h>

#include "tests/control/mixer_harness.h"

namespace hedgehog::control {
namespace {

void mix_circles(benchmark::State& state) {
  MixerHarness h;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    auto spec = MixerHarness::vibration(model::Waveform::kSine, 60, std::int64_t{1} << 60);
    spec.method = model::EffectMethod::kCircle;
    spec.trajectory.path = model::Path::kCircle;
    spec.trajectory.smooth = true;
    h.start(spec);
  }
  EventList events;
  for (auto _ : state) {
    ++h.inputs.tick;
    benchmark::DoNotOptimize(h.mixer.mix(h.inputs, events));
    h.mixer.account(1.0);
  }
}
BENCHMARK(mix_circles)->Arg(0)->Arg(1)->Arg(64);

}  // namespace
}  // namespace hedgehog::control
