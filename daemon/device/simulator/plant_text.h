// SPDX-License-Identifier: MIT
// Parameters of the simulated ball as one command-line argument of hedgehog-simboard.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/thermal/plant.h"

namespace hedgehog::device {

/// All numbers of `plant` but its seed, separated by commas, bit-exact.
std::string plant_text(const model::PlantParameters& plant);
/// nullopt: wrong number of values, or one that is not finite or out of range.
std::optional<model::PlantParameters> plant_from(std::string_view text);

}  // namespace hedgehog::device
