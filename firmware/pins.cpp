// SPDX-License-Identifier: MIT
#include "firmware/pins.h"

#include "firmware/pico_wiring.h"
#include "firmware/registers.h"
#include "firmware/sampling_point.h"

namespace hedgehog::firmware {
namespace {

// 2.3.1.7
constexpr uint32_t kInputs = kSio + 0x04;
constexpr uint32_t kOutputs = kSio + 0x10;
constexpr uint32_t kSetOutputs = kSio + 0x14;
constexpr uint32_t kClearOutputs = kSio + 0x18;
constexpr uint32_t kEnableOutputs = kSio + 0x24;

// 2.19.2
constexpr uint32_t kFunctionSpi = 1;
constexpr uint32_t kFunctionPwm = 4;
constexpr uint32_t kFunctionSio = 5;

// 2.19.6.3: input buffer, drive, pulls, Schmitt trigger.
constexpr uint32_t kPad = (1u << 6) | (1u << 1);
constexpr uint32_t kDrive4Ma = 1u << 4;
constexpr uint32_t kDrive12Ma = 3u << 4;
constexpr uint32_t kPullUp = 1u << 3;
constexpr uint32_t kPullDown = 1u << 2;

/// Counts up to the wrap value and back, a period of twice its cycles. The on-time is centred on
/// the counter's return to 0, whatever the compare value (4.5.2.1).
constexpr uint32_t kPhaseCorrect = 1u << 1;
/// Windings x and y, winding z.
constexpr uint32_t kBridgeSlices = (1u << 0) | (1u << 1);
constexpr uint32_t kFanSlice = 5;

constexpr uint32_t bit(uint32_t pin) noexcept { return 1u << pin; }
constexpr uint32_t kDirBits = 7u << kDirPin;

void connect(uint32_t pin, uint32_t function, uint32_t pull, uint32_t drive = kDrive4Ma) noexcept {
  reg(kPadsBank0 + 4 + 4 * pin) = kPad | drive | pull;
  reg(kIoBank0 + 4 + 8 * pin) = function;
}

void set_compare(const uint16_t (&pwm)[board::kWindings]) noexcept {
  reg(pwm_slice(0) + kPwmCompare) = pwm[0] | (uint32_t{pwm[1]} << 16);
  reg(pwm_slice(1) + kPwmCompare) = pwm[2];
}

/// From here on the flags show the end of this period, and the compare values are written within
/// it: not in its last half microsecond, nor in the first, which the counter does not tell from it.
void begin_turn() noexcept {
  constexpr uint32_t kNearWrap = 64;
  const uint32_t begin = now_us();
  while (reg(pwm_slice(0) + kPwmCounter) <= kNearWrap && now_us() - begin < kMaxTurnUs) {
  }
  reg(kPwmWraps) = kBridgeSlices;
}

/// The compare values count from the end of the period on, where the counter is back at 0
/// (4.5.2.3).
void wait_for_wrap() noexcept {
  const uint32_t begin = now_us();
  while ((reg(kPwmWraps) & kBridgeSlices) != kBridgeSlices && now_us() - begin < kMaxTurnUs) {
  }
}

void write_output(uint32_t pin, bool high) noexcept {
  reg(high ? kSetOutputs : kClearOutputs) = bit(pin);
}

}  // namespace

void start_pins() noexcept {
  reg(kClearOutputs) = ~0u;
  reg(kSetOutputs) = bit(kSpiSelectPin);
  for (uint32_t k = 0; k < board::kWindings; ++k) {
    connect(kDirPin + k, kFunctionSio, kPullDown);
    connect(kFaultPin + k, kFunctionSio, kPullUp);
  }
  // High, it feeds the resistor that holds the bridges asleep: 7.2 mA (firmware/board/common.net).
  connect(kSleepPin, kFunctionSio, kPullDown, kDrive12Ma);
  connect(kSupplySwitchPin, kFunctionSio, kPullDown);
  connect(kSpiSelectPin, kFunctionSio, kPullUp);
  connect(kLedPin, kFunctionSio, kPullDown);
  connect(kTachPin, kFunctionSio, kPullUp);
  connect(kVbusPin, kFunctionSio, 0);
  connect(kSpiInPin, kFunctionSpi, kPullDown);
  connect(kSpiClockPin, kFunctionSpi, kPullDown);
  connect(kSpiOutPin, kFunctionSpi, kPullDown);
  reg(kEnableOutputs) =
      kDirBits | bit(kSleepPin) | bit(kSupplySwitchPin) | bit(kSpiSelectPin) | bit(kLedPin);
  for (uint32_t k = 0; k < 2; ++k) {
    reg(pwm_slice(k) + kPwmControl) = kPhaseCorrect;
    reg(pwm_slice(k) + kPwmWrapValue) = kPwmTop;
    reg(pwm_slice(k) + kPwmCompare) = 0;
  }
  prepare_sampling_points();
  reg(pwm_slice(kFanSlice) + kPwmWrapValue) = kFanTop;
  reg(pwm_slice(kFanSlice) + kPwmCompare) = kFanTop;
  // At once, so that the bridges' periods begin together.
  reg(kPwmEnabled) = kBridgeSlices | (1u << kSamplingSlice) | (1u << kFanSlice);
  for (uint32_t k = 0; k < board::kWindings; ++k) connect(kPwmPin + k, kFunctionPwm, kPullDown);
  connect(kFanPin, kFunctionPwm, 0);
}

void set_pins(const board::PinOutputs& pins) noexcept {
  // What shall sleep does so first, what shall wake has its duty before it does.
  if (!pins.awake) write_output(kSleepPin, false);
  uint32_t direction = 0;
  for (uint32_t k = 0; k < board::kWindings; ++k)
    if (pins.reverse[k]) direction |= bit(kDirPin + k);
  const uint32_t turned = (reg(kOutputs) ^ direction) & kDirBits;
  if (turned != 0) begin_turn();
  set_compare(pins.pwm);
  if (turned != 0) {
    wait_for_wrap();
    reg(kSetOutputs) = turned & direction;
    reg(kClearOutputs) = turned & ~direction;
  }
  write_output(kSupplySwitchPin, pins.supply_switch_closed);
  if (pins.awake) write_output(kSleepPin, true);
  write_output(kLedPin, pins.awake);
  reg(pwm_slice(kFanSlice) + kPwmCompare) = pins.fan_pwm;
}

void set_safe_pins() noexcept {
  board::PinOutputs pins = board::safe_pins(pico_wiring());
  // As it is: open, it may have a reason; closed, opening it would interrupt a current.
  pins.supply_switch_closed = (reg(kOutputs) & bit(kSupplySwitchPin)) != 0;
  set_pins(pins);
}

uint8_t faults_low() noexcept { return static_cast<uint8_t>(~(reg(kInputs) >> kFaultPin) & 7u); }

bool bridges_awake() noexcept { return (reg(kOutputs) & bit(kSleepPin)) != 0; }

bool vbus_present() noexcept { return (reg(kInputs) & bit(kVbusPin)) != 0; }

}  // namespace hedgehog::firmware
