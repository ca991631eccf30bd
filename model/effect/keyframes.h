// SPDX-License-Identifier: MIT
// Key frames: direction and level of the push at points in time, with the interpolation between
// them. Used by `effect.play` and patterns (protocol/README.md).
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// Interpolation of level and direction to the next key frame: linear; constant until the next one;
/// smoothstep (3u^2 - 2u^3).
enum class Ease : std::uint8_t { kLinear, kStep, kSmooth };

/// 20 bytes, trivially copyable: the control thread stores hundreds of them.
struct Keyframe {
  /// Direction of the push, a unit vector in the pattern's frame (front is +x).
  float x = 1.0F;
  float y = 0.0F;
  float z = 0.0F;
  /// Fraction of the effect's strength, 0..1.
  float level = 0.0F;
  /// Milliseconds from the beginning of the pattern at rate 1; non-decreasing from one to the next.
  std::uint16_t t_ms = 0;
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

/// The pattern `at_ms` milliseconds (>= 0) from its beginning. Directions follow the great circle;
/// between opposite ones via the top (via the front for up and down). Before the first key frame
/// and after the last the level is 0. Of several at the same time the last applies. Real-time safe:
/// O(log n).
KeyframePoint point_at(std::span<const Keyframe> frames, double at_ms) noexcept;

/// Time of the last key frame; 0 without key frames.
double length_ms(std::span<const Keyframe> frames) noexcept;

/// The shortest rotation from front (+x) to `towards`, a unit vector; for straight back, half a
/// turn about +z.
Quaternion turn_from_front(const Vec3& towards) noexcept;

}  // namespace hedgehog::model
