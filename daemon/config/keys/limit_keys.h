// SPDX-License-Identifier: MIT
// The limits, present in two files: the device file contains the ceiling, the configuration may
// tighten it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/keys/key.h"
#include "base/keys/key_tree.h"
#include "model/limit/limits.h"

namespace hedgehog::config {

struct LimitField {
  std::string_view name;
  double model::Limits::*member;
  double min;
  double max;
  /// A perception threshold, not a protection: any value up to current_a is allowed.
  bool perception = false;
};

inline constexpr std::array<LimitField, 8> kLimitFields{{
    {"current_a", &model::Limits::current_a, 0.5, 15.0},
    {"continuous_a", &model::Limits::continuous_a, 0.5, 15.0},
    {"felt_a", &model::Limits::felt_a, 0.1, 15.0, true},
    {"derate_from_c", &model::Limits::derate_from_c, 30.0, 75.0},
    {"sustain_c", &model::Limits::sustain_c, 30.0, 75.0},
    {"zero_c", &model::Limits::zero_c, 30.0, 75.0},
    {"trip_c", &model::Limits::trip_c, 30.0, 75.0},
    {"rearm_c", &model::Limits::rearm_c, 25.0, 60.0},
}};

/// Limits of the configuration, in the order of kLimitFields; nullopt: the device file's.
using LimitOverrides = std::array<std::optional<double>, kLimitFields.size()>;

/// `ceiling` with `overrides`. An override above its ceiling is an error at its position.
model::Limits tightened(const model::Limits& ceiling, const LimitOverrides& overrides,
                        const keys::Origins& origins, keys::FileErrors& errors);

/// Errors unless rearm < derate_from < sustain < zero < trip, continuous <= current and felt <=
/// current.
void check_order(const model::Limits& limits, const keys::Origins& origins, const std::string& file,
                 keys::FileErrors& errors);

}  // namespace hedgehog::config
