// SPDX-License-Identifier: MIT
#include "daemon/control/state/disagreement.h"

#include <array>

namespace hedgehog::control {

std::string_view name(Quantity quantity) noexcept {
  constexpr std::array<std::string_view, kQuantities> kNames{
      "resistance", "current", "heat_balance", "thermistor", "supply_current", "supply_voltage"};
  return kNames[static_cast<std::size_t>(quantity)];
}

}  // namespace hedgehog::control
