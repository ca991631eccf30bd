// SPDX-License-Identifier: MIT
// The converter of the reference board: an MCP3208 (12 bits, 8 inputs) at SPI0.
#pragma once

#include <stdint.h>

#include "daemon/device/board_core/port.h"

namespace hedgehog::firmware {

/// REQUIRES: pins and clocks run.
void start_converter() noexcept;

/// Six of the eight inputs in each millisecond: of the thermistors one, in turn.
class Converter {
 public:
  /// Sleeps until the sampling point of `winding`, converts its current, then one of the others.
  /// Call it for 0, 1, 2, in three periods of the PWM: 195 us in all at most, the wait for the
  /// first period included. A conversion takes 20 us, so that two and 9 us of other work fit in a
  /// period; what takes longer delays the following conversions.
  void measure(uint32_t winding, board::RawInputs& raw) noexcept;

 private:
  void measure_thermistor(board::RawInputs& raw) noexcept;

  uint16_t ntc_adc_[board::kWindings] = {};
  uint32_t turn_ = 0;
  bool complete_ = false;
};

}  // namespace hedgehog::firmware
