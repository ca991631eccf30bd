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

/// 4.4.3.10: mode 0; between two words the clock pauses for two of its periods.
constexpr uint32_t kWordBits = 10;
/// 125 MHz / 2 / 52 = 1.2 MHz: the converter's limit is 1 MHz at 2.7 V and 2 MHz at 5 V. The small
/// prescaler lets a word begin within 16 ns, not within a clock.
constexpr uint32_t kDivider = 52;

uint32_t received() noexcept {
  while ((reg(kStatus) & kReceived) == 0) {
  }
  return reg(kData);
}

/// DS21298E, section 6.1, in two words: a zero, the start bit, single ended, three bits of the
/// input, two clocks for the sampling; then the twelve bits.
uint16_t convert(uint32_t input) noexcept {
  reg(kSio + 0x18) = 1u << kSpiSelectPin;
  reg(kData) = 0x180u | (input << 4);
  reg(kData) = 0;
  const uint32_t high = received();
  const uint32_t low = received();
  reg(kSio + 0x14) = 1u << kSpiSelectPin;
  // 500 ns between two conversions, three cycles a turn.
  for (int i = 0; i < 24; ++i) asm volatile("nop");
  return static_cast<uint16_t>(((high & 3u) << kWordBits) | (low & 0x3FFu));
}

}  // namespace

void start_converter() noexcept {
  reg(kPrescale) = 2;
  reg(kControl0) = ((kDivider - 1) << 8) | (kWordBits - 1);
  reg(kControl1) = 1u << 1;
}

void Converter::measure(uint32_t winding, board::RawInputs& raw) noexcept {
  if (winding == 0) clear_sampling_point();
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
