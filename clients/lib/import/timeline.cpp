// SPDX-License-Identifier: MIT
#include "clients/lib/import/timeline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hedgehog::client {

namespace {

using Point = Layer::Point;

constexpr double kLongestMs = model::kMaxKeyframeMs;
constexpr double kExact = 1e-4;

double between(const Point& a, const Point& b, double t_ms) noexcept {
  if (b.t_ms <= a.t_ms) return b.level;
  const double share = (t_ms - a.t_ms) / (b.t_ms - a.t_ms);
  const double way = a.smooth ? share * share * (3.0 - 2.0 * share) : share;
  return a.level + (b.level - a.level) * way;
}

/// Marks the inner points of `line[first..last]` that are needed to keep the error below
/// `tolerance` (Douglas and Peucker 1973, with the distance taken in the level).
void simplify(const std::vector<Point>& line, std::size_t from, std::size_t to, double tolerance,
              std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = std::abs(line[i].level - between(line[first], line[last], line[i].t_ms));
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (at != first) {
      kept[at] = true;
      open.emplace_back(first, at);
      open.emplace_back(at, last);
    }
  }
}

std::vector<Point> simplified(const std::vector<Point>& line, double tolerance) {
  std::vector<bool> kept(line.size(), false);
  kept.front() = true;
  kept.back() = true;
  std::size_t from = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i].smooth) {
      kept[i] = true;
      kept[i + 1] = true;
      simplify(line, from, i, tolerance, kept);
      from = i + 1;
    }
  }
  simplify(line, from, line.size() - 1, tolerance, kept);
  std::vector<Point> left;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) left.push_back(line[i]);
  return left;
}

/// Whether no other layer overlaps `layer` between `a` and `b`.
bool alone(const std::vector<Layer>& layers, const Layer& layer, const Point& a, const Point& b) {
  return std::none_of(
      layers.begin(), layers.end(),
      [&](const Layer& other) {
        return &other != &layer && other.points.front().t_ms < b.t_ms &&
               other.points.back().t_ms > a.t_ms;
      });
}

/// Times at which the slope of the sum changes, and at which smooth transitions begin.
struct Times {
  std::set<double> breakpoints{0.0};
  std::set<double> smooth;
};

void add_smooth(const std::vector<Layer>& layers, const Layer& layer, bool allow_smooth,
                Times& times) {
  constexpr int kPieces = 20;  // error of a segment of a smooth transition of height 1: 0.75 / 20^2
  for (std::size_t i = 0; i + 1 < layer.points.size(); ++i) {
    const Point& a = layer.points[i];
    const Point& b = layer.points[i + 1];
    if (!a.smooth || a.t_ms >= std::min(b.t_ms, kLongestMs)) continue;
    if (allow_smooth && b.t_ms <= kLongestMs && alone(layers, layer, a, b)) {
      times.smooth.insert(a.t_ms);
      continue;
    }
    const double end_ms = std::min(b.t_ms, kLongestMs);
    for (int piece = 1; piece < kPieces; ++piece)
      times.breakpoints.insert(a.t_ms + (end_ms - a.t_ms) * piece / kPieces);
  }
}

Times times_of(const std::vector<Layer>& layers, bool allow_smooth) {
  Times times;
  for (const Layer& layer : layers) {
    if (layer.points.front().t_ms >= kLongestMs) continue;
    for (const Point& point : layer.points)
      times.breakpoints.insert(std::min(point.t_ms, kLongestMs));
    add_smooth(layers, layer, allow_smooth, times);
  }
  return times;
}

std::vector<Point> line_of(const std::vector<Layer>& layers, bool allow_smooth, bool& clipped) {
  const auto cut = [&](double level) {
    clipped = clipped || level > 1.0 + kExact;
    return std::clamp(level, 0.0, 1.0);
  };
  const Times times = times_of(layers, allow_smooth);
  std::vector<Point> line;
  for (const double t_ms : times.breakpoints) {
    double before = 0.0;
    double after = 0.0;
    for (const Layer& layer : layers) {
      before += layer.before(t_ms);
      if (t_ms < kLongestMs) after += layer.after(t_ms);
    }
    before = cut(before);
    after = cut(after);
    const double whole_ms = std::round(t_ms);
    if (t_ms > 0.0) line.push_back({whole_ms, before});
    if (std::abs(after - before) > kExact || line.empty()) line.push_back({whole_ms, after});
    line.back().smooth = times.smooth.count(t_ms) > 0;
  }
  return line;
}

}  // namespace

double Layer::before(double t_ms) const noexcept {
  const auto at = std::lower_bound(points.begin(), points.end(), t_ms,
                                   [](const Point& p, double t) { return p.t_ms < t; });
  if (at == points.begin() || at == points.end()) return 0.0;
  return between(*(at - 1), *at, t_ms);
}

double Layer::after(double t_ms) const noexcept {
  const auto at = std::upper_bound(points.begin(), points.end(), t_ms,
                                   [](double t, const Point& p) { return t < p.t_ms; });
  if (at == points.begin() || at == points.end()) return 0.0;
  return between(*(at - 1), *at, t_ms);
}

double held(const std::vector<Point>& points, double t_ms) noexcept {
  if (t_ms <= points.front().t_ms) return points.front().level;
  const auto next = std::upper_bound(points.begin(), points.end(), t_ms,
                                     [](double t, const Point& p) { return t < p.t_ms; });
  return next == points.end() ? points.back().level : between(*(next - 1), *next, t_ms);
}

Keyframes keyframes_of(const std::vector<Layer>& layers) {
  Keyframes made;
  for (const Layer& layer : layers) {
    const bool late = layer.points.front().t_ms >= kLongestMs;
    made.late = made.late || late;
    made.cut = made.cut || (!late && layer.points.back().t_ms > kLongestMs);
  }
  std::vector<Point> line = line_of(layers, true, made.clipped);
  std::vector<Point> kept = simplified(line, kExact);
  made.simplified = kept.size() > model::kMaxKeyframes;
  if (made.simplified) line = line_of(layers, false, made.clipped);
  for (double tolerance = 0.002; kept.size() > model::kMaxKeyframes; tolerance *= 1.5)
    kept = simplified(line, tolerance);
  for (const Point& point : kept) {
    constexpr double kDecimals = 1e4;
    protocol::Keyframe frame;
    frame.t_ms = static_cast<std::int64_t>(point.t_ms);
    frame.level = std::round(point.level * kDecimals) / kDecimals;
    if (point.smooth) frame.ease = model::Ease::kSmooth;
    made.frames.push_back(frame);
  }
  return made;
}

}  // namespace hedgehog::client
