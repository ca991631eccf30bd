// SPDX-License-Identifier: MIT
// Inspection of an imported pattern in the tests of the importers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "clients/lib/import/import.h"
#include "model/effect/keyframes.h"

namespace hedgehog::client {

/// The level that the pattern plays at `t_ms`.
inline double level_at(const Imported& imported, double t_ms) {
  std::vector<model::Keyframe> frames;
  for (const protocol::Keyframe& k : imported.pattern.keyframes) {
    frames.push_back({1, 0, 0, static_cast<float>(k.level), static_cast<std::uint16_t>(k.t_ms),
                      k.ease.value_or(model::Ease::kLinear)});
  }
  return model::point_at(frames, t_ms).level;
}

/// The daemon's error for it; empty: accepted.
inline std::string error_message(const Imported& imported) {
  protocol::Pattern named = imported.pattern;
  named.name = "imported/sample";
  const auto decoded = protocol::decode_pattern(protocol::encode_pattern(named));
  return decoded ? std::string() : decoded.error().message;
}

}  // namespace hedgehog::client
