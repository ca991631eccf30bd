// SPDX-License-Identifier: MIT
// orientation.*
#pragma once

#include "protocol/method_info.h"
#include "protocol/methods/done.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct OrientationSet {
  static constexpr MethodInfo kMethod{"orientation.set",
                                      Role::kPlay,
                                      "Sets the orientation measured by an external sensor.",
                                      {ErrorCode::kUnsupported, ErrorCode::kClaimed}};
  using Result = Done;

  model::Quaternion
      quaternion{};  // device -> world; received within 1 % of unit length, normalised

  void describe(Fields& f);
  friend bool operator==(const OrientationSet&, const OrientationSet&) = default;
};

struct RecenterResult {
  static constexpr std::string_view kSchema = "Recentered";
  double yaw_offset_deg = 0.0;

  void describe(Fields& f) { f.required("yaw_offset_deg", yaw_offset_deg, decimals(2)); }
  friend bool operator==(const RecenterResult&, const RecenterResult&) = default;
};

/// Sets the azimuth of the front.
struct OrientationRecenter {
  static constexpr MethodInfo kMethod{"orientation.recenter",
                                      Role::kPlay,
                                      "Sets the azimuth of the ball's front.",
                                      {ErrorCode::kDeviceAbsent}};
  using Result = RecenterResult;

  double azimuth_deg = 0.0;

  void describe(Fields& f) { f.defaulted("azimuth_deg", azimuth_deg, {.min = -360, .max = 360}); }
  friend bool operator==(const OrientationRecenter&, const OrientationRecenter&) = default;
};

/// Normalises `q`, the member `field`; rejects it if its length is off by more than 1 %.
void normalise(Fields& f, std::string_view field, model::Quaternion& q);

using OrientationMethods = TypeList<OrientationSet, OrientationRecenter>;

}  // namespace hedgehog::protocol
