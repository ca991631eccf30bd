// SPDX-License-Identifier: MIT
#include "daemon/server/effects/load.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::server {
namespace {

using model::Vec3;

constexpr double kMsPerTick = 1e3 * model::kTickSeconds;

/// Mean over one period as a fraction of the peak; every waveform runs between 0 and 1.
double mean_fraction(const model::EffectSpec& spec) noexcept {
  switch (spec.waveform) {
    case model::Waveform::kConstant:
      return 1.0;
    case model::Waveform::kSquare:
      return spec.on_fraction;
    default:
      return 0.5;
  }
}

Vec3 in_device(const model::EffectSpec& spec, const Vec3& direction,
               const model::Quaternion& device_to_world) noexcept {
  return spec.frame == model::Frame::kWorld
             ? model::rotate(model::conjugate(device_to_world), direction)
             : direction;
}

Vec3 in_windings(const model::EffectSpec& spec, const Vec3& device_direction,
                 const model::CoilModel& coils) noexcept {
  return spec.frame == model::Frame::kCoil ? device_direction : coils.matrix * device_direction;
}

Vec3 squares(const Vec3& v) noexcept { return {v.x * v.x, v.y * v.y, v.z * v.z}; }

/// Played length of its pattern, ms at rate 1.
double played_ms(const model::EffectSpec& spec, double length_ms) noexcept {
  const model::KeyframePlayback& playback = spec.trajectory.playback;
  return playback.loop || spec.duration <= 0
             ? length_ms
             : std::min(length_ms, static_cast<double>(spec.duration) * kMsPerTick * playback.rate);
}

/// The waveform is independent of the key frames.
Load load_of_keyframes(const model::EffectSpec& spec, const KeyframeTrack& track,
                       const model::CoilModel& coils,
                       const model::Quaternion& device_to_world) noexcept {
  const auto turned = [&](const Vec3& v) {
    return in_windings(
        spec, in_device(spec, model::rotate(spec.trajectory.playback.turn, v), device_to_world),
        coils);
  };
  const double requested_a = spec.strength_a * spec.gain;
  const double rms = model::rms_fraction(spec);
  const Moments mean = track.mean_over(played_ms(spec, track.length_ms()));
  Load load;
  load.mean_a = (requested_a * mean_fraction(spec)) * turned(mean.first);
  // Diagonal of T M T' for the linear map T = `turned`.
  const Vec3 x = turned({1, 0, 0});
  const Vec3 y = turned({0, 1, 0});
  const Vec3 z = turned({0, 0, 1});
  for (int coil = 0; coil < model::kCoils; ++coil) {
    const Vec3 row{x[coil], y[coil], z[coil]};
    const double square = requested_a * requested_a * rms * rms * dot(row, mean.second * row);
    load.variance_a2[coil] = square - load.mean_a[coil] * load.mean_a[coil];
  }
  load.varying_a = peak_a(spec, &track);
  return load;
}

}  // namespace

model::RequestedCurrents Load::requested() const noexcept {
  const Vec3 square = squares(mean_a) + variance_a2;
  return {{std::sqrt(std::max(0.0, square.x)), std::sqrt(std::max(0.0, square.y)),
           std::sqrt(std::max(0.0, square.z))},
          peak_a()};
}

Load operator+(const Load& a, const Load& b) noexcept {
  return {a.mean_a + b.mean_a, a.variance_a2 + b.variance_a2, a.steady_a + b.steady_a,
          a.varying_a + b.varying_a};
}

Load scaled(const Load& load, double factor) noexcept {
  return {factor * load.mean_a, factor * factor * load.variance_a2, factor * load.steady_a,
          factor * load.varying_a};
}

double peak_a(const model::EffectSpec& spec, const KeyframeTrack* track) noexcept {
  return spec.strength_a * spec.gain * (track != nullptr ? track->peak : 1.0);
}

Load load_of(const model::EffectSpec& spec, const KeyframeTrack* track,
             const model::CoilModel& coils, const model::Quaternion& device_to_world) noexcept {
  if (track != nullptr) return load_of_keyframes(spec, *track, coils, device_to_world);
  const model::Ring ring = model::ring_of(spec.trajectory);
  const int steps = std::max(1, ring.steps);
  Vec3 mean_direction;
  Vec3 mean_square;
  model::EffectPhase phase;
  for (int step = 0; step < steps; ++step) {
    phase.steps = step;
    const Vec3 direction = in_windings(
        spec, in_device(spec, model::direction_at(ring, phase), device_to_world), coils);
    mean_direction = mean_direction + (1.0 / steps) * direction;
    mean_square = mean_square + (1.0 / steps) * squares(direction);
  }
  const double peak_a = spec.strength_a * spec.gain;
  const double rms = model::rms_fraction(spec);
  Load load;
  load.mean_a = (peak_a * mean_fraction(spec)) * mean_direction;
  load.variance_a2 = (peak_a * peak_a * rms * rms) * mean_square - squares(load.mean_a);
  if (steps == 1 && spec.waveform == model::Waveform::kConstant)
    load.steady_a = load.mean_a;
  else
    load.varying_a = peak_a;
  return load;
}

Vec3 onset_direction(const model::EffectSpec& spec, const KeyframeTrack* track,
                     const model::CoilModel& coils,
                     const model::Quaternion& device_to_world) noexcept {
  const Vec3 own = track != nullptr
                       ? model::rotate(spec.trajectory.playback.turn, track->peak_direction)
                       : model::direction_at(model::ring_of(spec.trajectory), {});
  const Vec3 direction = in_device(spec, own, device_to_world);
  return spec.frame == model::Frame::kCoil
             ? model::unit_or(model::field_of({direction}, coils).a, direction)
             : direction;
}

}  // namespace hedgehog::server
