// SPDX-License-Identifier: MIT
// Measurements that contradict each other: detail of a trip besides its reason.
#pragma once

#include <cstdint>
#include <string_view>

namespace hedgehog::control {

/// Measured or derived quantities. The wire names are the enumerators in snake_case without the k
/// (`heat_balance`).
enum class Quantity : std::uint8_t {
  kResistance,     // V/I of a winding
  kCurrent,        // by the winding's current sensor
  kHeatBalance,    // heat input, through the thermal network
  kThermistor,     // on a winding
  kSupplyCurrent,  // drawn by all bridges
  kSupplyVoltage,  // at the board
};
inline constexpr int kQuantities = 6;

/// "heat_balance".
std::string_view name(Quantity quantity) noexcept;

/// Trivially copyable.
class Disagreement {
 public:
  constexpr Disagreement() noexcept = default;
  /// `coil` 0..2. Two quantities, or more where they cannot be distinguished.
  template <class... Quantities>
  constexpr Disagreement(int coil, Quantities... between) noexcept
      : coil_(static_cast<std::int8_t>(coil)),
        between_(static_cast<std::uint8_t>((... | bit(between)))) {}

  /// Adds one more possible quantity.
  constexpr Disagreement with(Quantity quantity) const noexcept {
    Disagreement more = *this;
    more.between_ = static_cast<std::uint8_t>(between_ | bit(quantity));
    return more;
  }
  constexpr bool any() const noexcept { return between_ != 0; }
  /// The winding, 0..2.
  constexpr int coil() const noexcept { return coil_; }
  constexpr bool has(Quantity quantity) const noexcept { return (between_ & bit(quantity)) != 0; }

  friend constexpr bool operator==(const Disagreement&, const Disagreement&) noexcept = default;

 private:
  static constexpr unsigned bit(Quantity quantity) noexcept {
    return 1u << static_cast<unsigned>(quantity);
  }
  std::int8_t coil_ = 0;
  std::uint8_t between_ = 0;
};

}  // namespace hedgehog::control
