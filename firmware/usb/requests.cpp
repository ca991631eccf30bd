// SPDX-License-Identifier: MIT
#include "firmware/usb/requests.h"

namespace hedgehog::firmware {
namespace {

// Table 9-4.
constexpr uint8_t kGetStatus = 0;
constexpr uint8_t kClearFeature = 1;
constexpr uint8_t kSetFeature = 3;
constexpr uint8_t kSetAddress = 5;
constexpr uint8_t kGetDescriptor = 6;
constexpr uint8_t kGetConfiguration = 8;
constexpr uint8_t kSetConfiguration = 9;
constexpr uint8_t kGetInterface = 10;
constexpr uint8_t kSetInterface = 11;

// Table 9-2.
constexpr uint8_t kToHost = 0x80;
constexpr uint8_t kDevice = 0;
constexpr uint8_t kInterface = 1;
constexpr uint8_t kEndpoint = 2;
constexpr uint8_t kVendorFromDevice = 0xC0;

constexpr uint16_t kMicrosoftDescriptorIndex = 7;
constexpr uint8_t kBusPowered = 0;
constexpr uint8_t kOut = 0x01;
constexpr uint8_t kIn = 0x81;

UsbAnswer stall() noexcept {
  UsbAnswer answer;
  answer.stalled = true;
  return answer;
}

UsbAnswer action(UsbAction what, uint16_t argument) noexcept {
  UsbAnswer answer;
  answer.action = what;
  answer.argument = static_cast<uint8_t>(argument);
  return answer;
}

UsbAnswer found(const Descriptor& descriptor) noexcept {
  if (descriptor.bytes == nullptr) return stall();
  UsbAnswer answer;
  answer.data = descriptor;
  return answer;
}

}  // namespace

UsbAnswer UsbRequests::data(uint8_t byte, uint8_t second, uint16_t length) noexcept {
  small_[0] = byte;
  small_[1] = second;
  return found({small_, length});
}

UsbAnswer UsbRequests::answer(const SetupPacket& setup) noexcept {
  if (setup.request_type == kVendorFromDevice)
    return setup.request == kMicrosoftRequest && setup.index == kMicrosoftDescriptorIndex
               ? found(microsoft_descriptors())
               : stall();
  switch (setup.request_type & ~kToHost) {
    case kDevice:
      return of_device(setup);
    case kInterface:
      return of_interface(setup);
    case kEndpoint:
      return of_endpoint(setup);
    default:
      return stall();
  }
}

UsbAnswer UsbRequests::of_device(const SetupPacket& setup) noexcept {
  if ((setup.request_type & kToHost) != 0) {
    switch (setup.request) {
      case kGetStatus:
        return data(kBusPowered);
      case kGetConfiguration:
        return data(configuration_, 0, 1);
      case kGetDescriptor:
        return found(descriptor(static_cast<uint8_t>(setup.value >> 8),
                                static_cast<uint8_t>(setup.value & 0xFF)));
      default:
        return stall();
    }
  }
  if (setup.request == kSetAddress && setup.value < 128)
    return action(UsbAction::kSetAddress, setup.value);
  if (setup.request == kSetConfiguration && setup.value <= 1) {
    halted_in_ = false;
    halted_out_ = false;
    configuration_ = static_cast<uint8_t>(setup.value);
    return action(UsbAction::kConfigure, setup.value);
  }
  return stall();
}

UsbAnswer UsbRequests::of_interface(const SetupPacket& setup) noexcept {
  if (!configured() || setup.index != 0) return stall();
  if ((setup.request_type & kToHost) != 0) {
    if (setup.request == kGetStatus) return data(0);
    return setup.request == kGetInterface ? data(0, 0, 1) : stall();
  }
  // 9.4.10: its endpoints begin anew.
  if (setup.request == kSetInterface && setup.value == 0) {
    halted_in_ = false;
    halted_out_ = false;
    return action(UsbAction::kConfigure, 1);
  }
  return stall();
}

UsbAnswer UsbRequests::of_endpoint(const SetupPacket& setup) noexcept {
  if ((setup.index & 0x7F) == 0)
    return setup.request_type == (kToHost | kEndpoint) && setup.request == kGetStatus ? data(0)
                                                                                      : stall();
  if (!configured() || (setup.index != kIn && setup.index != kOut)) return stall();
  bool& halted = setup.index == kIn ? halted_in_ : halted_out_;
  if ((setup.request_type & kToHost) != 0)
    return setup.request == kGetStatus ? data(halted ? 1 : 0) : stall();
  // Feature 0 is ENDPOINT_HALT, the only one of an endpoint.
  if (setup.value != 0 || (setup.request != kSetFeature && setup.request != kClearFeature))
    return stall();
  halted = setup.request == kSetFeature;
  return action(halted ? UsbAction::kHalt : UsbAction::kClearHalt, setup.index);
}

}  // namespace hedgehog::firmware
