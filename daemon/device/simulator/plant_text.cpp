// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/plant_text.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "base/number_text.h"

namespace hedgehog::device {
namespace {

/// Calls `any` with every number that may be negative, `each` with the others, always in the same
/// order.
template <class Plant, class Each, class Any>
void visit(Plant& plant, Each each, Any any) {
  for (auto& value : plant.winding_j_k) each(value);
  each(plant.core_j_k);
  for (auto& value : plant.winding_to_core_k_w) each(value);
  each(plant.core_to_ambient_fan_k_w);
  each(plant.core_to_ambient_still_k_w);
  for (auto& value : plant.r25_ohm) each(value);
  each(plant.inductance_h);
  each(plant.freewheel_v);
  each(plant.supply_v);
  each(plant.sensor_lag_s);
  each(plant.sensor_noise_k);
  each(plant.fan_full_rpm);
  each(plant.fan_spin_up_s);
  each(plant.force_slope_n_a);
  for (auto& row : plant.coil_matrix.row)
    for (auto* value : {&row.x, &row.y, &row.z}) any(*value);
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (;;) {
    double value = 0.0;
    const auto result = std::from_chars(at, end, value);
    if (result.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    if (result.ptr == end) return numbers;
    if (*result.ptr != ',') return std::nullopt;
    at = result.ptr + 1;
  }
}

}  // namespace

std::string plant_text(const model::PlantParameters& plant) {
  std::string text = std::to_string(plant.sensor_winding);
  // std::to_string would depend on the locale and truncate digits.
  const auto add = [&text](double value) { text += ',' + base::shortest(value); };
  visit(plant, add, add);
  return text;
}

std::optional<model::PlantParameters> plant_from(std::string_view text) {
  const auto numbers = numbers_in(text);
  if (!numbers) return std::nullopt;
  model::PlantParameters plant;
  std::size_t next = 1;
  bool possible = true;
  const auto any = [&](double& value) {
    if (next < numbers->size()) value = (*numbers)[next];
    ++next;
  };
  const auto each = [&](double& value) {
    any(value);
    possible = possible && value >= 0.0;
  };
  visit(plant, each, any);
  const double winding = numbers->front();
  if (!possible || next != numbers->size() || winding != std::floor(winding) || winding < 0.0 ||
      winding >= model::kCoils)
    return std::nullopt;
  plant.sensor_winding = static_cast<int>(winding);
  return plant;
}

}  // namespace hedgehog::device
