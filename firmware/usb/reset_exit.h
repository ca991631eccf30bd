// SPDX-License-Identifier: MIT
// Erratum RP2040-E5, chips before B2: after a reset of the bus the controller wants 800 us of idle
// line before it listens, which it never gets on a hub that is busy with others. So the line is
// shown to it as idle for a millisecond, through pin 15, the only way there is to its input. (What
// is to be set: the erratum, and pico-sdk, src/rp2_common/pico_fix.)
#pragma once

#include "firmware/registers.h"

namespace hedgehog::firmware {

class UsbResetExit {
 public:
  /// A reset of the bus was seen.
  void begin() noexcept {
    if (state_ == State::kForced) show_bus();
    state_ = chip_is_affected() ? State::kReset : State::kNone;
  }

  /// Whenever the loop wakes.
  void poll() noexcept {
    if (state_ == State::kReset && line_state() != 0) {
      show_idle();
      since_us_ = now_us();
      state_ = State::kForced;
    } else if (state_ == State::kForced && now_us() - since_us_ > kIdleUs) {
      show_bus();
      state_ = State::kNone;
    }
  }

 private:
  enum class State : uint8_t { kNone, kReset, kForced };
  static constexpr uint32_t kIdleUs = 1000;

  static constexpr uint32_t kPin = 15;
  static constexpr uint32_t kPinControl = kIoBank0 + 4 + 8 * kPin;
  static constexpr uint32_t kPinPad = kPadsBank0 + 4 + 4 * kPin;
  // 2.19.6.1: the controller's own inputs, not driven, read as high; and nothing, as in reset.
  static constexpr uint32_t kShownHigh = 8u | (2u << 12) | (3u << 16);
  static constexpr uint32_t kNoFunction = 0x1F;
  static constexpr uint32_t kKeeperPad = (1u << 6) | (1u << 3) | (1u << 2);
  static constexpr uint32_t kResetPad = 0x56;
  // 4.1.4
  static constexpr uint32_t kMuxing = kUsb + 0x74;
  static constexpr uint32_t kMuxingPhy = (1u << 3) | (1u << 0);
  static constexpr uint32_t kMuxingPin = (1u << 3) | (1u << 2);
  static constexpr uint32_t kPhyDirect = kUsb + 0x7C;
  static constexpr uint32_t kPhyOverride = kUsb + 0x80;
  static constexpr uint32_t kPullUpDp = 1u << 1;
  static constexpr uint32_t kPullUpDpOverride = 1u << 2;

  /// 2.20.1: revision 2 is B2, the first without the erratum.
  static bool chip_is_affected() noexcept { return (reg(kSysInfo) >> 28) < 2; }
  static uint32_t line_state() noexcept { return (reg(kUsb + 0x50) >> 2) & 3u; }

  static void show_idle() noexcept {
    reg(kPinPad) = kKeeperPad;
    reg(kPinControl) = kShownHigh;
    // The host goes on seeing the pull-up.
    reg(kPhyDirect) = kPullUpDp;
    reg(kPhyOverride) = kPullUpDpOverride;
    reg(kMuxing) = kMuxingPin;
  }
  static void show_bus() noexcept {
    reg(kMuxing) = kMuxingPhy;
    reg(kPhyOverride) = 0;
    reg(kPinControl) = kNoFunction;
    reg(kPinPad) = kResetPad;
  }

  State state_ = State::kNone;
  uint32_t since_us_ = 0;
};

}  // namespace hedgehog::firmware
