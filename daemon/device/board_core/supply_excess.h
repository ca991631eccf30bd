// SPDX-License-Identifier: MIT
// More current drawn from the supply than the windings carry: a current sensor does not detect one,
// or reads low.
#pragma once

#include <stdint.h>

#include "daemon/device/board_core/limits.h"
#include "daemon/device/board_core/low_pass.h"
#include "daemon/device/board_core/persistence.h"

namespace hedgehog::board {

class SupplyExcess {
 public:
  /// Advances by one millisecond with the supply current as measured and as expected by the
  /// windings' currents, mA, each at most 2^17; both 0 while they are not compared. True while the
  /// measured one exceeds the expected one for kExcessSupplyMs, or in the mean.
  bool step(uint32_t drawn_ma, uint32_t expected_ma) noexcept {
    const bool exceeds = drawn_ma > with_tolerance(expected_ma) + kExcessSupplyMa;
    drawn_.step(drawn_ma);
    expected_.step(expected_ma);
    const bool mean_exceeds =
        drawn_.mean_ma() > with_tolerance(expected_.mean_ma()) + kExcessSupplyMeanMa;
    return persistent_.step(exceeds) || mean_exceeds;
  }

 private:
  /// Gain errors of the sensors in windings and supply line.
  static constexpr uint32_t with_tolerance(uint32_t ma) noexcept { return ma + ma / 8u; }

  Persistence persistent_{kExcessSupplyMs};
  LowPass drawn_{kSupplyMeanShift};
  LowPass expected_{kSupplyMeanShift};
};

}  // namespace hedgehog::board
