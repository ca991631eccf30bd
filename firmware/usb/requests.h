// SPDX-License-Identifier: MIT
// Endpoint 0 without its registers: from the eight bytes of a setup packet to what is answered
// (Universal Serial Bus Specification 2.0, chapter 9).
#pragma once

#include <stdint.h>

#include "firmware/usb/descriptors.h"

namespace hedgehog::firmware {

struct SetupPacket {
  uint8_t request_type = 0;
  uint8_t request = 0;
  uint16_t value = 0;
  uint16_t index = 0;
  uint16_t length = 0;
};

/// What the device shall do besides its answer.
enum class UsbAction : uint8_t { kNone, kSetAddress, kConfigure, kHalt, kClearHalt };

struct UsbAnswer {
  bool stalled = false;
  /// Sent when the host wants to read; otherwise only the status stage follows.
  Descriptor data;
  UsbAction action = UsbAction::kNone;
  /// The address, or the endpoint with its direction bit, or the configuration.
  uint8_t argument = 0;
};

class UsbRequests {
 public:
  UsbAnswer answer(const SetupPacket& setup) noexcept;
  void reset() noexcept { *this = UsbRequests{}; }

  bool configured() const noexcept { return configuration_ != 0; }

 private:
  UsbAnswer of_device(const SetupPacket& setup) noexcept;
  UsbAnswer of_interface(const SetupPacket& setup) noexcept;
  UsbAnswer of_endpoint(const SetupPacket& setup) noexcept;
  UsbAnswer data(uint8_t byte, uint8_t second = 0, uint16_t length = 2) noexcept;

  uint8_t configuration_ = 0;
  bool halted_in_ = false;
  bool halted_out_ = false;
  uint8_t small_[2] = {};
};

}  // namespace hedgehog::firmware
