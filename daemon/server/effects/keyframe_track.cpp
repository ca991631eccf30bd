// SPDX-License-Identifier: MIT
#include "daemon/server/effects/keyframe_track.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

namespace hedgehog::server {
namespace {

/// Gauss-Legendre on -1..1: nodes and weights, exact for the smooth ease with a constant direction.
constexpr std::array<std::pair<double, double>, 4> kGauss{
    {{-0.8611363115940526, 0.3478548451374538},
     {-0.3399810435848563, 0.6521451548625461},
     {0.3399810435848563, 0.6521451548625461},
     {0.8611363115940526, 0.3478548451374538}}};

Moments sum(const Moments& a, const Moments& b, double factor) noexcept {
  Moments result;
  result.first = a.first + factor * b.first;
  for (int row = 0; row < 3; ++row)
    result.second.row[row] = a.second.row[row] + factor * b.second.row[row];
  return result;
}

/// Within one segment between consecutive key frames.
Moments integral(std::span<const model::Keyframe> frames, double from_ms, double to_ms) noexcept {
  Moments result;
  const double half_ms = 0.5 * (to_ms - from_ms);
  for (const auto& [node, weight] : kGauss) {
    const model::KeyframePoint point = model::point_at(frames, from_ms + half_ms * (1.0 + node));
    const model::Vec3 push = point.level * point.direction;
    result =
        sum(result, {push, {{push[0] * push, push[1] * push, push[2] * push}}}, half_ms * weight);
  }
  return result;
}

void measure(KeyframeTrack& track) {
  track.until.resize(track.frames.size());
  for (std::size_t i = 1; i < track.frames.size(); ++i) {
    track.until[i] =
        sum(track.until[i - 1],
            integral(track.frames, track.frames[i - 1].t_ms, track.frames[i].t_ms), 1.0);
  }
  for (const model::Keyframe& frame : track.frames) {
    if (frame.level > track.peak) {
      track.peak = frame.level;
      track.peak_direction = frame.direction();
    }
  }
}

}  // namespace

Moments KeyframeTrack::mean_over(double ms) const noexcept {
  const auto next =
      std::upper_bound(frames.begin(), frames.end(), ms,
                       [](double at, const model::Keyframe& frame) { return at < frame.t_ms; });
  if (ms <= 0.0 || next == frames.begin()) return {};
  const auto last = static_cast<std::size_t>(next - frames.begin()) - 1;
  const Moments whole = next == frames.end()
                            ? until[last]
                            : sum(until[last], integral(frames, frames[last].t_ms, ms), 1.0);
  return sum({}, whole, 1.0 / ms);
}

protocol::Result<KeyframeTrackPtr> make_keyframe_track(
    const std::vector<protocol::Keyframe>& keyframes, const model::PinArray& pins) {
  auto track = std::make_shared<KeyframeTrack>();
  track->frames.reserve(keyframes.size());
  model::Vec3 direction{1, 0, 0};
  for (const protocol::Keyframe& keyframe : keyframes) {
    if (keyframe.direction) {
      const auto resolved =
          protocol::resolve(*keyframe.direction, pins,
                            "keyframes[" + std::to_string(track->frames.size()) + "].direction");
      if (resolved.has_error()) return resolved.error();
      direction = *resolved;
    }
    track->frames.push_back({static_cast<float>(direction.x), static_cast<float>(direction.y),
                             static_cast<float>(direction.z), static_cast<float>(keyframe.level),
                             static_cast<std::uint16_t>(keyframe.t_ms),
                             keyframe.ease.value_or(model::Ease::kLinear)});
  }
  measure(*track);
  return KeyframeTrackPtr(std::move(track));
}

}  // namespace hedgehog::server
