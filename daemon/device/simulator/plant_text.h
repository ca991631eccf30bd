// SPDX-License-Identifier: MIT
// Parameters of the simulated ball as one argument of a command line, for hedgehog-simboard.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/thermal/plant.h"

namespace hedgehog::device {

/// All numbers of `plant` but its seed, by comma, exact to the bit.
std::string plant_text(const model::PlantParameters& plant);
/// nullopt: not that many numbers, one that is not finite, or one that cannot be.
std::optional<model::PlantParameters> plant_from(std::string_view text);

}  // namespace hedgehog::device
