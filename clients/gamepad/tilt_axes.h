// SPDX-License-Identifier: MIT
// Stick position from the tilt of the ball. Pure; one thread.
#pragma once

#include <cstdint>
#include <optional>

#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::gamepad {

struct TiltOptions {
  double full_deg = 40.0;      // tilt of full deflection; above dead_zone_deg
  double dead_zone_deg = 3.0;  // smaller tilts are the centre
  /// Exponent from the tilt beyond the dead zone, 0..1, to the deflection: 1 linear, 2 fine near
  /// the centre.
  double curve = 1.5;
};

/// -32767..32767. x is positive for a tilt to the right; y for a tilt towards the back (the stick
/// pulled).
struct StickPosition {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const StickPosition&, const StickPosition&) = default;
};
inline constexpr std::int32_t kStickEnd = 32'767;

class TiltAxes {
 public:
  explicit TiltAxes(const TiltOptions& options) : options_(options) {}

  /// The orientation at the next `position` becomes the centre.
  void recentre() noexcept { neutral_.reset(); }
  bool has_centre() const noexcept { return neutral_.has_value(); }
  /// `up`: the unit vector against gravity in the device frame (x forward, y left, z up).
  StickPosition position(const model::Vec3& up);

 private:
  TiltOptions options_;
  std::optional<model::Quaternion> neutral_;  // rotates the up vector at the centre to (0, 0, 1)
};

}  // namespace hedgehog::gamepad
