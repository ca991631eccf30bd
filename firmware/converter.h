// SPDX-License-Identifier: MIT
// The converter of the reference board: an MCP3208 (12 bits, 8 inputs) at SPI0.
#pragma once

#include <stdint.h>

#include "daemon/device/board_core/port.h"

namespace hedgehog::firmware {

/// REQUIRES: pins and clocks run.
void start_converter() noexcept;

/// One of the thermistors in turn, the supply, its current, then the currents of the windings one
/// after the other, so that they are as young as `Wiring::converted_before_us` takes them to be.
/// Six conversions, 125 us. The thermistors are complete in each third call.
class Converter {
 public:
  void measure(board::RawInputs& raw) noexcept;

 private:
  uint16_t ntc_adc_[board::kWindings] = {};
  uint32_t turn_ = 0;
  bool complete_ = false;
};

}  // namespace hedgehog::firmware
