// SPDX-License-Identifier: MIT
// Exact cooling of the four nodes without current; and the thermal constants for which filter,
// floor and plant can integrate in steps of up to 0.1 s.
#pragma once

#include "model/thermal/thermal_model.h"

namespace hedgehog::model {

/// Time constants of single nodes with their neighbours held constant.
struct NodeTimeConstants {
  double winding_s = 0.0;  // minimum of the three windings
  double core_s = 0.0;     // by the lower thermal resistance to ambient, with or without fan
};
NodeTimeConstants node_time_constants(const ThermalModel& model) noexcept;

/// An explicit step of a tenth of this is accurate to 5 %, does not oscillate, and leaves a factor
/// of ten for constants that differ from the device file.
inline constexpr double kMinTimeConstantS = 1.0;
inline constexpr double kMinSensorLagS = 0.1;  // the filter divides by it

/// `nodes` after `seconds` (negative: 0), coils off and fan stopped; the result is within the range
/// of ambient and nodes. Not for the control thread.
ThermalState decayed(const ThermalModel& model, const ThermalState& nodes, double ambient_c,
                     double seconds) noexcept;

}  // namespace hedgehog::model
