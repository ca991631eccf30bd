// SPDX-License-Identifier: MIT
// Laws of the mixer under arbitrary clients.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <map>

#include "daemon/control/effects/mixer.h"
#include "tests/control/mixer_harness.h"

namespace hedgehog::control {
namespace {

using model::EffectSpec;
using model::Tick;

double tenths(int from, int to) { return *rc::gen::inRange(from, to) / 10.0; }

EffectSpec any_spec() {
  EffectSpec spec = MixerHarness::pulse();
  spec.method = static_cast<model::EffectMethod>(*rc::gen::inRange(0, 4));
  spec.frame = static_cast<model::Frame>(*rc::gen::inRange(0, 3));
  spec.waveform = static_cast<model::Waveform>(*rc::gen::inRange(0, 6));
  spec.priority = static_cast<std::uint8_t>(*rc::gen::inRange(3, 7));
  spec.finish_on_close = *rc::gen::arbitrary<bool>();
  spec.strength_a = tenths(0, 151);
  spec.gain = tenths(0, 11);
  spec.frequency_hz = tenths(5, 2501);
  if (spec.method == model::EffectMethod::kCircle) {
    spec.trajectory.path = model::Path::kCircle;
    spec.trajectory.ring_deg = *rc::gen::inRange(0, 181);
    spec.trajectory.speed_pins_s = tenths(1, 1001);
    spec.trajectory.smooth = *rc::gen::arbitrary<bool>();
  }
  spec.delay = *rc::gen::inRange(0, 50);
  spec.envelope.attack = *rc::gen::inRange(0, 100);
  spec.envelope.fade = *rc::gen::inRange(0, 100);
  const bool leased = *rc::gen::arbitrary<bool>();
  spec.duration = leased ? 0 : *rc::gen::inRange(1, 300);
  spec.lease = leased ? *rc::gen::inRange(100, 300) : 0;
  return spec;
}

// For any client requests, every effect ends once and by itself, is reported once as started before
// that, and leaves no demand on the coils.
RC_GTEST_PROP(MixerLaws, EveryEffectEndsOnceAndInTime, ()) {
  MixerHarness h;
  std::map<EffectId, Tick> deadline;
  EffectId newest = 0;
  const auto pick = [&] { return static_cast<EffectId>(*rc::gen::inRange(1, 1 + (int)newest)); };
  for (int i = 0, n = *rc::gen::inRange(1, 120); i < n; ++i) {
    h.passed = tenths(0, 11);
    h.inputs.orientation_usable = *rc::gen::inRange(0, 5) > 0;
    const int what = *rc::gen::inRange(0, 10);
    if (newest == 0 || (what < 4 && newest < kEffectPlaces)) {
      const EffectSpec spec = any_spec();
      const EffectId replaces = newest > 0 && what == 0 ? pick() : 0;
      newest = h.start(spec, replaces);
      deadline[newest] = h.now() + spec.delay + spec.duration + spec.lease;
    } else if (what == 4) {
      h.stop(pick());
    } else if (what == 5) {
      h.stop(pick(), EndReason::kDisconnected);
    } else if (what == 6) {
      const EffectId effect = pick();
      const EffectSpec spec = any_spec();
      h.update(effect, spec);
      deadline[effect] += 50 + 300 + 300;
    } else if (what == 7) {
      h.inputs.tick += *rc::gen::inRange(0, 50);
    }
    for (int j = *rc::gen::inRange(1, 30); j > 0; --j) {
      h.tick();
      RC_ASSERT(model::is_finite(h.last.field.a) && model::is_finite(h.last.coil_a));
    }
  }
  for (int left = 100'000; left > 0 && !h.mixer.empty(); --left) h.tick();
  RC_ASSERT(h.mixer.empty());
  RC_ASSERT(h.tick() == model::Vec3());
  std::map<EffectId, int> started;
  std::map<EffectId, int> ended;
  for (const Event& event : h.events) {
    if (event.type == EventType::kEffectStarted) ++started[event.effect];
    if (event.type != EventType::kEffectEnded) continue;
    RC_ASSERT(started[event.effect] == 1);
    ++ended[event.effect];
    RC_ASSERT(event.tick <= deadline[event.effect] + 100);
    RC_ASSERT(event.delivery.min >= 0.0);
    RC_ASSERT(event.delivery.min <= event.delivery.mean + 1e-12);
    RC_ASSERT(event.delivery.mean <= 1.0 + 1e-12);
  }
  for (EffectId effect = 1; effect <= newest; ++effect) RC_ASSERT(ended[effect] == 1);
}

// A continuous waveform stays continuous when its frequency, strength or the whole effect changes:
// the difference between two ticks is at most its maximum slope.
RC_GTEST_PROP(MixerLaws, UpdatesAndReplacementsNeverJump, ()) {
  MixerHarness h;
  const auto waveform = *rc::gen::element(model::Waveform::kSine, model::Waveform::kTriangle);
  EffectSpec spec = MixerHarness::vibration(waveform, 20);
  EffectId effect = h.start(spec);
  double before = h.tick().x / spec.strength_a;
  for (int i = 0; i < 60; ++i) {
    spec.frequency_hz = tenths(5, 400);
    spec.strength_a = tenths(10, 151);
    if (*rc::gen::arbitrary<bool>())
      h.update(effect, spec);
    else
      effect = h.start(spec, effect);
    for (int j = *rc::gen::inRange(1, 20); j > 0; --j) {
      const double level = h.tick().x / spec.strength_a;
      const double steepest = waveform == model::Waveform::kSine ? 3.1416 : 2.0;
      RC_ASSERT(std::abs(level - before) <= steepest * spec.frequency_hz * 1e-3 + 1e-9);
      before = level;
    }
  }
}

// A smooth circle stays continuous when its speed, sense or ring changes at the same angle.
RC_GTEST_PROP(MixerLaws, ACircleNeverJumps, ()) {
  MixerHarness h;
  EffectSpec spec = MixerHarness::hold({1, 0, 0}, 5, 10'000);
  spec.method = model::EffectMethod::kCircle;
  spec.trajectory.path = model::Path::kCircle;
  spec.trajectory.smooth = true;
  const EffectId effect = h.start(spec);
  model::Vec3 before = h.tick();
  for (int i = 0; i < 60; ++i) {
    spec.trajectory.speed_pins_s = tenths(1, 1001);
    spec.trajectory.clockwise = *rc::gen::arbitrary<bool>();
    spec.trajectory.ring_deg = *rc::gen::inRange(30, 150);
    h.update(effect, spec);
    for (int j = *rc::gen::inRange(1, 20); j > 0; --j) {
      const model::Vec3 now = h.tick();
      const double turned = std::remainder(
          std::atan2(now.y, now.x) - std::atan2(before.y, before.x), 2 * 3.14159265358979);
      const double max_step = 2 * 3.1416 / model::circle_steps(spec.trajectory.ring_deg) * 1e-3 *
                              spec.trajectory.speed_pins_s;
      RC_ASSERT(std::abs(turned) <= max_step + 1e-9);
      before = now;
    }
  }
}

// A copy of the mixer continues exactly like the original: the flight recorder relies on it.
RC_GTEST_PROP(MixerLaws, ACopyContinuesBitForBit, ()) {
  MixerHarness h;
  for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
    h.start(any_spec());
    h.run(*rc::gen::inRange(1, 40));
  }
  MixerHarness copy = h;
  for (int i = 0; i < 400; ++i) RC_ASSERT(h.tick() == copy.tick());
}

}  // namespace
}  // namespace hedgehog::control
