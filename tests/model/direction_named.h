// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "model/geometry/direction.h"

namespace hedgehog::model {

/// The unit vector of one of the six words, in lower case; nullopt for any other.
inline std::optional<Vec3> direction_named(std::string_view name) {
  for (const NamedDirection& known : kNamedDirections)
    if (known.name == name) return known.vector;
  return std::nullopt;
}

}  // namespace hedgehog::model
