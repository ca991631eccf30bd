// SPDX-License-Identifier: MIT
// The stick that tilting the ball is. Pure; one thread.
#pragma once

#include <cstdint>
#include <optional>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::gamepad {

struct TiltOptions {
  double full_deg = 40.0;      // the tilt of a stick at its end; above dead_zone_deg
  double dead_zone_deg = 3.0;  // tilts below are the centre
  /// The stick is the tilt beyond the dead zone, 0..1, to this power: 1 even, 2 fine near the
  /// centre.
  double curve = 1.5;
};

/// -32767..32767. x: tilted to the right is positive; y: towards the back (the stick pulled) is.
struct StickPosition {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const StickPosition&, const StickPosition&) = default;
};
inline constexpr std::int32_t kStickEnd = 32'767;

class TiltAxes {
 public:
  explicit TiltAxes(const TiltOptions& options) : options_(options) {}

  /// How the ball is held in the next `position` is the centre.
  void recentre() noexcept { neutral_.reset(); }
  /// `up`: the unit vector against gravity in the ball's frame (x forward, y left, z up).
  StickPosition position(const model::Vec3& up);

 private:
  TiltOptions options_;
  std::optional<model::Quaternion> neutral_;  // turns up as it was held into (0, 0, 1)
};

}  // namespace hedgehog::gamepad
