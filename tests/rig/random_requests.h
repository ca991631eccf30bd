// SPDX-License-Identifier: MIT
// Random requests of several clients: short taps, long holds, circles, vibrations, mostly too
// strong. Each client has its own effect lengths and pauses.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/effect/effect.h"
#include "model/random_stream.h"
#include "tests/rig/rig.h"

namespace hedgehog::rig {

/// One client. Deterministic from its random stream.
struct Temper {
  double mean_pause_s = 1.0;
  double mean_length_s = 1.0;
  double strong = 0.5;  // share of effects at the full 15 A

  static Temper draw(model::RandomStream& random) noexcept {
    Temper temper;
    temper.mean_pause_s = std::pow(10.0, random.uniform(-1.5, 1.5));
    temper.mean_length_s = std::pow(10.0, random.uniform(-1.5, 1.0));
    temper.strong = random.uniform(0.0, 1.0);
    return temper;
  }
};

inline double exponential(model::RandomStream& random, double mean) noexcept {
  return -mean * std::log(1.0 - random.uniform(0.0, 1.0));
}

inline model::Vec3 random_direction(model::RandomStream& random) noexcept {
  // Often along one winding: the worst case for that winding.
  model::Vec3 v{random.gaussian(), random.gaussian(), random.gaussian()};
  if (random.uniform(0.0, 1.0) < 0.4) {
    v = {};
    v[static_cast<int>(random.bits() % 3)] = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  }
  return unit_or(v, {1, 0, 0});
}

inline model::EffectSpec random_effect(model::RandomStream& random, const Temper& temper) noexcept {
  using model::EffectMethod;
  const double strength =
      random.uniform(0.0, 1.0) < temper.strong ? 15.0 : random.uniform(0.0, 15.0);
  const auto length = static_cast<model::Tick>(
      std::clamp(1000.0 * exponential(random, temper.mean_length_s), 5.0, 10'000.0));
  model::EffectSpec spec = pulse(random_direction(random), strength, length);
  spec.method = static_cast<EffectMethod>(random.bits() % 4);
  spec.priority = static_cast<std::uint8_t>(4 + random.bits() % 3);
  switch (spec.method) {
    case EffectMethod::kPulse:
    case EffectMethod::kPlay:  // never drawn here; it needs key frames
      break;
    case EffectMethod::kCircle:
      spec.trajectory.path = model::Path::kCircle;
      spec.trajectory.axis = random_direction(random);
      spec.trajectory.ring_deg = random.uniform(10.0, 170.0);
      spec.trajectory.speed_pins_s = random.uniform(0.5, 50.0);
      spec.trajectory.smooth = random.bits() % 2 == 0;
      break;
    case EffectMethod::kVibrate:
      spec.waveform = static_cast<model::Waveform>(1 + random.bits() % 5);
      spec.frequency_hz = std::pow(10.0, random.uniform(-0.3, 2.397));
      spec.on_fraction = random.uniform(0.05, 0.95);
      break;
    case EffectMethod::kHold:
      spec.lease = std::max<model::Tick>(length, 100);
      spec.duration = 0;
      break;
  }
  if (spec.lease == 0 && random.bits() % 4 == 0) {
    spec.envelope.attack = length / 4;
    spec.envelope.fade = length / 4;
  }
  return spec;
}

}  // namespace hedgehog::rig
