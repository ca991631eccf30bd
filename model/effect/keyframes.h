// SPDX-License-Identifier: MIT
// Key frames: where the pins push and how strongly, at points in time, with the way from each to
// the next. What `effect.play` plays and patterns are made of (protocol/README.md).
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::model {

/// How level and direction go from a key frame to the next one: evenly; not at all until the next
/// one comes; slowly at both ends (3u^2 - 2u^3).
enum class Ease : std::uint8_t { kLinear, kStep, kSmooth };

/// 20 bytes, trivially copyable: they are stored by the hundred in the control thread.
struct Keyframe {
  /// Unit vector towards which the pins push, in the pattern's frame (it faces front, +x).
  float x = 1.0F;
  float y = 0.0F;
  float z = 0.0F;
  /// 0..1 of the effect's strength.
  float level = 0.0F;
  /// Milliseconds from the beginning of the pattern at rate 1; never falls from one to the next.
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

/// The pattern `at_ms` milliseconds (>= 0) from its beginning. Directions go along the great
/// circle; between opposite ones over the top (over the front when they are up and down). Before
/// the first key frame and after the last it rests: level 0. Of several at one time the last
/// counts. Real-time safe: O(log n).
KeyframePoint point_at(std::span<const Keyframe> frames, double at_ms) noexcept;

/// The time of the last one; 0 for none.
double length_ms(std::span<const Keyframe> frames) noexcept;

/// The shortest turn that takes front (+x) to `towards`, a unit vector; straight back is half a
/// turn about up.
Quaternion turn_from_front(const Vec3& towards) noexcept;

}  // namespace hedgehog::model
