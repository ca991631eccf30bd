// SPDX-License-Identifier: MIT
// Key frames of effects: direction and level of the push over time (protocol/README.md).
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// Interpolation to the next key frame: linear; constant until there; smoothstep (3u^2 - 2u^3).
enum class Ease : std::uint8_t { kLinear, kStep, kSmooth };

/// Direction: a unit vector in the pattern's frame (front is +x). 20 bytes, trivially copyable.
struct Keyframe {
  float x = 1.0F;
  float y = 0.0F;
  float z = 0.0F;
  float level = 0.0F;      // fraction of the effect's strength, 0..1
  std::uint16_t t_ms = 0;  // from the beginning of the pattern at rate 1; non-decreasing
  Ease ease = Ease::kLinear;

  Vec3 direction() const noexcept { return {x, y, z}; }
};
static_assert(std::is_trivially_copyable_v<Keyframe>);

inline constexpr int kMaxKeyframes = 256;
inline constexpr int kMaxKeyframeMs = 60'000;

struct KeyframePoint {
  Vec3 direction{1, 0, 0};  // unit vector
  double level = 0.0;       // 0..1
};

/// The pattern at `at_ms` >= 0. Directions follow the great circle, between opposite ones via the
/// top (via the front for up and down). Level 0 before the first key frame and after the last; of
/// several at the same time the last applies. Real-time safe: O(log n).
KeyframePoint point_at(std::span<const Keyframe> frames, double at_ms) noexcept;

/// Time of the last key frame; 0 without key frames.
double length_ms(std::span<const Keyframe> frames) noexcept;

/// The shortest rotation from front (+x) to a unit vector; straight back: half a turn about +z.
Quaternion turn_from_front(const Vec3& towards) noexcept;

}  // namespace hedgehog::model
