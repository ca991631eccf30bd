// SPDX-License-Identifier: MIT
// A simulated board that measures exactly: for tests of the link and of the windings' physics. Its
// electronics have tests of their own (front_end_test.cpp).
#pragma once

#include "daemon/device/simulator/simulated_board.h"

namespace hedgehog::device {

inline SimulatedBoardOptions exact() {
  SimulatedBoardOptions options;
  options.front_end.kind = FrontEndKind::kIdeal;
  return options;
}

}  // namespace hedgehog::device
