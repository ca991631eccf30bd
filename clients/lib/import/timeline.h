// SPDX-License-Identifier: MIT
// Pushes that overlap in time, added up and written as the key frames of one pattern.
#pragma once

#include <string>
#include <vector>

#include "protocol/values/effect_params.h"

namespace hedgehog::client {

/// A level that is nothing before the first point and after the last; two points at one time are a
/// jump. Times in milliseconds never fall.
struct Layer {
  struct Point {
    double t_ms = 0.0;
    double level = 0.0;
    /// To the next one as `model::Ease::kSmooth` goes, else along a straight line.
    bool smooth = false;
  };
  std::vector<Point> points;

  /// Just before `t_ms`, and from it on.
  double before(double t_ms) const noexcept;
  double after(double t_ms) const noexcept;
};

/// Along `points`, at least one, but the first one's level before them and the last one's after.
double held(const std::vector<Layer::Point>& points, double t_ms) noexcept;

struct Keyframes {
  /// All zero when nothing begins before the longest time that a pattern has.
  std::vector<protocol::Keyframe> frames;
  /// The sum was above 1 somewhere and was cut there.
  bool clipped = false;
  /// Layers that begin after the longest time of a pattern are not in it.
  bool late = false;
  /// One went on beyond that time.
  bool cut = false;
  /// It took more than 256 key frames; what matters least is not in it.
  bool simplified = false;
};

/// The sum of `layers`, cut to 0..1, with times rounded to whole milliseconds. A smooth way that is
/// there alone stays exact; any other is drawn with straight lines, off by less than 0.002.
Keyframes keyframes_of(const std::vector<Layer>& layers);

}  // namespace hedgehog::client
