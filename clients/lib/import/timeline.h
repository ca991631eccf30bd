// SPDX-License-Identifier: MIT
// Overlapping pushes, added up and converted to the key frames of one pattern.
#pragma once

#include <string>
#include <vector>

#include "protocol/values/effect_params.h"

namespace hedgehog::client {

/// A level over time, 0 before the first point and after the last; two points at one time are a
/// jump. Times in ms, non-decreasing.
struct Layer {
  struct Point {
    double t_ms = 0.0;
    double level = 0.0;
    /// To the next point by `model::Ease::kSmooth`, else linear.
    bool smooth = false;
  };
  std::vector<Point> points;

  /// The level just before `t_ms`, and at it.
  double before(double t_ms) const noexcept;
  double after(double t_ms) const noexcept;
};

/// The level along `points`, at least one; before the first and after the last point theirs is
/// held.
double held(const std::vector<Layer::Point>& points, double t_ms) noexcept;

struct Keyframes {
  /// All zero if nothing begins before the maximum duration of a pattern.
  std::vector<protocol::Keyframe> frames;
  /// The sum exceeded 1 and was clamped.
  bool clipped = false;
  /// Layers that begin after the maximum duration of a pattern were left out.
  bool late = false;
  /// A layer was cut at that duration.
  bool cut = false;
  /// More than 256 key frames were needed; the least significant were left out.
  bool simplified = false;
};

/// The sum of `layers`, clamped to 0..1, with times rounded to whole milliseconds. A smooth
/// transition without overlap stays exact; any other is approximated by line segments, with an
/// error below 0.002.
Keyframes keyframes_of(const std::vector<Layer>& layers);

}  // namespace hedgehog::client
