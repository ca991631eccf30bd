// SPDX-License-Identifier: MIT
#include "clients/gamepad/force_profile.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::gamepad {

namespace {

/// The level of an envelope has the sign of its force.
double envelope_force(std::uint16_t level, double sign_of) {
  return std::copysign(std::min(1.0, level / kFullForce), sign_of);
}

std::vector<ForcePoint> with_zero_crossings(const std::vector<ForcePoint>& points) {
  std::vector<ForcePoint> all;
  for (const ForcePoint& point : points) {
    if (!all.empty() && all.back().force * point.force < 0.0) {
      const ForcePoint from = all.back();
      const double part = from.force / (from.force - point.force);
      const auto span = static_cast<double>(point.t_ms - from.t_ms);
      all.push_back({from.t_ms + std::llround(part * span), 0.0});
    }
    all.push_back(point);
  }
  return all;
}

}  // namespace

std::vector<ForcePoint> force_profile(double begin, double end, std::int64_t length_ms,
                                      const ff_envelope& envelope, bool has_end) {
  const auto base = [&](std::int64_t t_ms) {
    return begin + (end - begin) * static_cast<double>(t_ms) / static_cast<double>(length_ms);
  };
  const std::int64_t attack_ends = std::min<std::int64_t>(envelope.attack_length, length_ms);
  const std::int64_t fade_ms = has_end ? envelope.fade_length : 0;
  const std::int64_t fade_begins = std::max(length_ms - fade_ms, attack_ends);

  std::vector<ForcePoint> points;
  if (attack_ends > 0) points.push_back({0, envelope_force(envelope.attack_level, base(0))});
  points.push_back({attack_ends, base(attack_ends)});
  if (fade_begins > attack_ends) points.push_back({fade_begins, base(fade_begins)});
  if (fade_begins < length_ms)
    points.push_back({length_ms, envelope_force(envelope.fade_level, base(length_ms))});
  return with_zero_crossings(points);
}

}  // namespace hedgehog::gamepad
