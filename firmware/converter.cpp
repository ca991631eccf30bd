// SPDX-License-Identifier: MIT
#include "firmware/converter.h"

#include "firmware/pins.h"
#include "firmware/registers.h"
#include "firmware/sampling_point.h"

namespace hedgehog::firmware {
namespace {

// Inputs of the MCP3208.
constexpr uint32_t kCurrentInput = 0;  // 0, 1, 2
constexpr uint32_t kShuntInput = 3;
constexpr uint32_t kSupplyInput = 4;
constexpr uint32_t kNtcInput = 5;  // 5, 6, 7

// 4.4.4
constexpr uint32_t kControl0 = kSpi0 + 0x00;
constexpr uint32_t kControl1 = kSpi0 + 0x04;
constexpr uint32_t kData = kSpi0 + 0x08;
constexpr uint32_t kStatus = kSpi0 + 0x0C;
constexpr uint32_t kPrescale = kSpi0 + 0x10;
constexpr uint32_t kReceived = 1u << 2;

uint32_t exchange(uint32_t byte) noexcept {
  reg(kData) = byte;
  while ((reg(kStatus) & kReceived) == 0) {
  }
  return reg(kData);
}

/// DS21298E, section 6.1: 24 clocks; start bit, single ended, three bits of the input; the twelve
/// bits come last.
uint16_t convert(uint32_t input) noexcept {
  reg(kSio + 0x18) = 1u << kSpiSelectPin;
  exchange(0x06u | (input >> 2));
  const uint32_t high = exchange((input & 3u) << 6);
  const uint32_t low = exchange(0);
  reg(kSio + 0x14) = 1u << kSpiSelectPin;
  // 500 ns between two conversions, three cycles a turn.
  for (int i = 0; i < 24; ++i) asm volatile("nop");
  return static_cast<uint16_t>(((high & 0x0Fu) << 8) | (low & 0xFFu));
}

}  // namespace

void start_converter() noexcept {
  // 125 MHz / 104 = 1.2 MHz: the converter's limit is 1 MHz at 2.7 V and 2 MHz at 5 V.
  reg(kPrescale) = 104;
  reg(kControl0) = 7;  // 8 bits, mode 0
  reg(kControl1) = 1u << 1;
}

void Converter::measure(uint32_t winding, board::RawInputs& raw) noexcept {
  wait_for_sampling_point();
  raw.current_adc[winding] = convert(kCurrentInput + winding);
  if (winding == 0)
    measure_thermistor(raw);
  else if (winding == 1)
    raw.supply_adc = convert(kSupplyInput);
  else
    raw.shunt_adc = convert(kShuntInput);
}

void Converter::measure_thermistor(board::RawInputs& raw) noexcept {
  ntc_adc_[turn_] = convert(kNtcInput + turn_);
  turn_ = turn_ == 2 ? 0 : turn_ + 1;
  raw.ntc_converted = turn_ == 0;
  complete_ |= raw.ntc_converted;
  for (uint32_t k = 0; k < board::kWindings; ++k) {
    // Before the first round the others count as what was converted: a thermistor that nobody has
    // looked at is neither open nor short.
    raw.ntc_adc[k] = complete_ || k < turn_ ? ntc_adc_[k] : ntc_adc_[0];
  }
}

}  // namespace hedgehog::firmware
