// SPDX-License-Identifier: MIT
#include "model/effect/effect.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::model {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// A phase this close below a boundary counts as having reached it: 100 x 0.01 must be a whole
/// step.
constexpr double kPhaseRounding = 1e-9;

double whole(double x) noexcept { return std::floor(x + kPhaseRounding); }

/// Wraps `x` into 0..`period`; true if it wrapped.
bool wrap(double& x, double period) noexcept {
  if (x < period - kPhaseRounding) return false;
  x = std::max(0.0, x - whole(x / period) * period);
  return true;
}

std::uint32_t next_noise(std::uint32_t state) noexcept {  // xorshift32, Marsaglia 2003
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state;
}
double noise_level(std::uint32_t state) noexcept { return state / 4294967296.0; }

double waveform_level(const EffectSpec& spec, const EffectPhase& phase) noexcept {
  const double w = phase.wave;
  switch (spec.waveform) {
    case Waveform::kConstant:
      return 1.0;
    case Waveform::kSine:
      return 0.5 - 0.5 * std::cos(2.0 * kPi * w);
    case Waveform::kSquare:
      return w < spec.on_fraction - kPhaseRounding ? 1.0 : 0.0;
    case Waveform::kTriangle:
      return w < 0.5 ? 2.0 * w : 2.0 * (1.0 - w);
    case Waveform::kSawtooth:
      return w;
    case Waveform::kNoise:
      return (1.0 - w) * noise_level(phase.noise) + w * noise_level(next_noise(phase.noise));
  }
  return 0.0;
}

double envelope_level(const EffectSpec& spec, Tick elapsed) noexcept {
  const Envelope& e = spec.envelope;
  double level = 1.0;
  if (elapsed < e.attack) {
    const double done = static_cast<double>(elapsed) / static_cast<double>(e.attack);
    level = e.attack_level + (1.0 - e.attack_level) * done;
  }
  if (spec.duration > 0) {
    const Tick left = std::max<Tick>(0, spec.duration - elapsed);
    if (left < e.fade) {
      const double rest = static_cast<double>(left) / static_cast<double>(e.fade);
      level = std::min(level, e.fade_level + (1.0 - e.fade_level) * rest);
    }
  }
  return level;
}

}  // namespace

int circle_steps(double ring_deg, double pitch_deg) noexcept {
  const double steps = std::round(360.0 * std::sin(ring_deg * kPi / 180.0) / pitch_deg);
  return std::max(1, static_cast<int>(steps));
}

Ring ring_of(const Trajectory& trajectory) noexcept {
  if (trajectory.path != Path::kCircle) return {.along = trajectory.direction};
  const Vec3& axis = trajectory.axis;
  const Vec3 ahead{1, 0, 0};
  const Vec3 top{0, 0, 1};
  const Vec3 flat = ahead - dot(ahead, axis) * axis;
  const Vec3 front = unit_or(norm(flat) > 1e-6 ? flat : top - dot(top, axis) * axis, top);
  const double angle = trajectory.ring_deg * kPi / 180.0;
  const double radius = std::sin(angle);
  return {.along = std::cos(angle) * axis,
          .front = radius * front,
          .side = (trajectory.clockwise ? -radius : radius) * cross(axis, front),
          .steps = circle_steps(trajectory.ring_deg, trajectory.pitch_deg),
          .smooth = trajectory.smooth};
}

Vec3 direction_at(const Ring& ring, const EffectPhase& phase) noexcept {
  if (ring.steps == 0) return ring.along;
  const double steps = ring.smooth
                           ? phase.steps
                           : static_cast<double>(static_cast<int>(phase.steps + kPhaseRounding));
  const double angle = 2.0 * kPi * steps / ring.steps;
  return ring.along + std::cos(angle) * ring.front + std::sin(angle) * ring.side;
}

Vec3 direction_at(const Trajectory& trajectory, const EffectPhase& phase) noexcept {
  return direction_at(ring_of(trajectory), phase);
}

double level_at(const EffectSpec& spec, const EffectPhase& phase) noexcept {
  return envelope_level(spec, phase.elapsed) * waveform_level(spec, phase);
}

EffectPhase advanced(const EffectSpec& spec, const Ring& ring, EffectPhase phase,
                     Tick ticks) noexcept {
  const double seconds = kTickSeconds * static_cast<double>(ticks);
  phase.elapsed += ticks;
  if (spec.waveform != Waveform::kConstant) {
    phase.wave += spec.frequency_hz * seconds;
    if (wrap(phase.wave, 1.0)) phase.noise = next_noise(phase.noise);
  }
  if (ring.steps > 0) {
    phase.steps += spec.trajectory.speed_pins_s * seconds;
    wrap(phase.steps, ring.steps);
  }
  if (spec.trajectory.path == Path::kKeyframes) {
    const KeyframePlayback& playback = spec.trajectory.playback;
    phase.steps += playback.rate * static_cast<double>(ticks);
    if (playback.loop) wrap(phase.steps, playback.length_ms);
  }
  return phase;
}

EffectPhase advanced(const EffectSpec& spec, EffectPhase phase) noexcept {
  return advanced(spec, ring_of(spec.trajectory), phase, 1);
}

EffectPhase carried(const EffectSpec& from, const EffectSpec& to, EffectPhase phase) noexcept {
  if (from.trajectory.path == Path::kKeyframes && to.trajectory.path == Path::kKeyframes &&
      from.trajectory.playback.same_frames(to.trajectory.playback))
    return phase;
  if (from.trajectory.path != Path::kCircle || to.trajectory.path != Path::kCircle) {
    phase.steps = 0.0;
    return phase;
  }
  const int before = circle_steps(from.trajectory.ring_deg, from.trajectory.pitch_deg);
  const int after = circle_steps(to.trajectory.ring_deg, to.trajectory.pitch_deg);
  if (from.trajectory.clockwise != to.trajectory.clockwise) {
    // Reverses from the current step once its remaining time has elapsed.
    const double stands = to.trajectory.smooth ? phase.steps : whole(phase.steps);
    phase.steps = before - stands + (phase.steps - stands);
  }
  phase.steps *= static_cast<double>(after) / before;
  wrap(phase.steps, after);
  return phase;
}

Tick ticks_to_end(const KeyframePlayback& playback, double at_ms) noexcept {
  const double left = std::max(0.0, playback.length_ms - at_ms) / playback.rate;
  return static_cast<Tick>(std::ceil(left - kPhaseRounding));
}

double rms_fraction(const EffectSpec& spec) noexcept {
  switch (spec.waveform) {
    case Waveform::kConstant:
      return 1.0;
    case Waveform::kSine:  // of (1 - cos) / 2
      return std::sqrt(3.0 / 8.0);
    case Waveform::kSquare:
      return std::sqrt(spec.on_fraction);
    case Waveform::kTriangle:
    case Waveform::kSawtooth:
      return std::sqrt(1.0 / 3.0);
    case Waveform::kNoise:  // interpolates uniform levels: 2/3 of 1/3 and 1/3 of 1/4
      return std::sqrt(11.0 / 36.0);
  }
  return 1.0;
}

}  // namespace hedgehog::model
