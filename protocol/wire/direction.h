// SPDX-License-Identifier: MIT
// A direction as given by the client: the one in which the pins push out, never the origin of a
// force. `resolve` converts it into a unit vector of the effect's frame (x forward, y left, z up).
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "model/geometry/pin_array.h"
#include "model/vec3.h"
#include "protocol/wire/error.h"

namespace hedgehog::protocol {

class Fields;

/// Degrees. Azimuth anticlockwise seen from above (0 front, 90 left), -360..360; elevation -90
/// (down) .. 90 (up).
struct Angles {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
  void describe(Fields& f);
  friend constexpr bool operator==(const Angles&, const Angles&) noexcept = default;
};

/// A pin number; pins are numbered ring by ring from the top, anticlockwise from the front.
struct PinNumber {
  std::int64_t pin = 0;
  void describe(Fields& f);
  friend constexpr bool operator==(const PinNumber&, const PinNumber&) noexcept = default;
};

enum class Word : std::uint8_t { kUp, kDown, kLeft, kRight, kFront, kBack };
std::string_view name(Word enumerator) noexcept;

/// Vec3: any non-zero finite length.
using Direction = std::variant<model::Vec3, Angles, PinNumber, Word>;

/// The unit vector of `direction`. An error names `field` when the ball has no such pin.
Result<model::Vec3> resolve(const Direction& direction, const model::PinArray& pins,
                            std::string_view field = "direction");

}  // namespace hedgehog::protocol
