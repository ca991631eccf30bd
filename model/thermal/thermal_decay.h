// SPDX-License-Identifier: MIT
// How the four nodes cool without current, exactly; and which thermal constants the integration of
// filter, floor and plant in steps of up to 0.1 s can follow.
#pragma once

#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// How fast each node would follow its neighbours if those stood still, s.
struct NodeTimeConstants {
  /// Of the fastest winding.
  double winding_s = 0.0;
  /// By the better of the two ways to the room, with fan and without.
  double core_s = 0.0;
};
NodeTimeConstants node_time_constants(const ThermalModel& model) noexcept;

/// An explicit step of a tenth of this is exact to a twentieth, does not oscillate, and has a
/// factor of ten for constants that are not what the device file says.
inline constexpr double kMinTimeConstantS = 1.0;
/// The filter divides by the thermistor's lag.
inline constexpr double kMinSensorLagS = 0.1;

/// `nodes` after `seconds` in a room of `ambient_c`, coils off and fan standing. Negative seconds
/// count as none. Never below both the room and the coolest node, never above the hottest of them.
/// Not for the control thread.
ThermalState decayed(const ThermalModel& model, const ThermalState& nodes, double ambient_c,
                     double seconds) noexcept;

}  // namespace hedgehog::model
