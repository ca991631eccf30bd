// SPDX-License-Identifier: MIT
#include "emulator/gadget.h"

namespace hedgehog::emulator {
namespace {

constexpr std::uint8_t kHidDescriptor = 0x21;
constexpr std::uint8_t kReportDescriptor = 0x22;

constexpr std::uint8_t kHidClass = 3;

constexpr Byte low(std::size_t number) { return static_cast<Byte>(number); }
constexpr Byte high(std::size_t number) { return static_cast<Byte>(number >> 8); }

Bytes hid_descriptor(const InterfaceShape& interface) {
  const std::size_t size = interface.report_descriptor.size();
  return {9, kHidDescriptor, 0x11, 0x01, 0, 1, kReportDescriptor, low(size), high(size)};
}

}  // namespace

Exported Gadget::exported() const {
  Exported made;
  made.vendor = shape_.vendor;
  made.product = shape_.product;
  for (const InterfaceShape& interface : shape_.interfaces)
    made.interfaces.push_back({interface.code, interface.subclass, interface.protocol});
  return made;
}

std::optional<Bytes> Gadget::handle_control(const SetupPacket& /*setup*/,
                                            std::span<const Byte> /*data*/) {
  return std::nullopt;
}

void Gadget::plugged() {
  waiting_.clear();
  halts_.clear();
}

bool Gadget::halted(std::uint8_t address) const {
  const auto found = halts_.find(address);
  return found != halts_.end() && found->second > 0;
}

bool Gadget::clear_halt(std::uint8_t address) {
  if (halted(address)) --halts_[address];
  return true;
}

void Gadget::out(std::uint8_t endpoint, std::span<const Byte> data) { handle_out(endpoint, data); }

void Gadget::give(std::uint8_t endpoint, Bytes packet) {
  auto& waiting = waiting_[endpoint];
  if (waiting.size() == kWaiting) {
    waiting.pop_front();
    ++lost_;
  }
  waiting.push_back(std::move(packet));
}

std::optional<Bytes> Gadget::take(std::uint8_t endpoint) {
  auto& waiting = waiting_[endpoint];
  if (waiting.empty()) return std::nullopt;
  Bytes packet = std::move(waiting.front());
  waiting.pop_front();
  return packet;
}

Bytes Gadget::device_descriptor() const {
  return {18,
          kDeviceDescriptor,
          0x00,
          0x02,
          0,
          0,
          0,
          64,
          low(shape_.vendor),
          high(shape_.vendor),
          low(shape_.product),
          high(shape_.product),
          0x00,
          0x01,
          1,
          2,
          3,
          1};
}

Bytes Gadget::configuration_descriptor() const {
  constexpr Byte kSelfPowered = 0xC0;
  Bytes bytes{9, kConfigurationDescriptor, 0, 0, low(shape_.interfaces.size()), 1, 0, kSelfPowered,
              50};
  Byte number = 0;
  for (const InterfaceShape& interface : shape_.interfaces) {
    bytes.insert(bytes.end(), {9, 4, number++, 0, low(interface.endpoints.size()), interface.code,
                               interface.subclass, interface.protocol, 0});
    if (interface.code == kHidClass) {
      const Bytes hid = hid_descriptor(interface);
      bytes.insert(bytes.end(), hid.begin(), hid.end());
    }
    for (const EndpointShape& endpoint : interface.endpoints) {
      bytes.insert(bytes.end(), {7, 5, endpoint.address, Byte{endpoint.bulk ? Byte{2} : Byte{3}},
                                 low(endpoint.bytes), high(endpoint.bytes),
                                 Byte{endpoint.bulk ? Byte{0} : Byte{1}}});
    }
  }
  bytes[2] = low(bytes.size());
  bytes[3] = high(bytes.size());
  return bytes;
}

std::optional<Bytes> Gadget::string_descriptor(std::size_t index) const {
  if (index == 0) return Bytes{4, kStringDescriptor, 0x09, 0x04};  // US English
  const std::string* texts[] = {&shape_.manufacturer, &shape_.name, &shape_.serial};
  if (index > 3) return std::nullopt;
  Bytes bytes{0, kStringDescriptor};
  for (const char c : *texts[index - 1]) bytes.insert(bytes.end(), {static_cast<Byte>(c), 0});
  bytes[0] = low(bytes.size());
  return bytes;
}

std::optional<Bytes> Gadget::descriptor(const SetupPacket& setup) const {
  const auto type = static_cast<std::uint8_t>(setup.value >> 8);
  if (setup.type == kToHost && type == kDeviceDescriptor) return device_descriptor();
  if (setup.type == kToHost && type == kConfigurationDescriptor) return configuration_descriptor();
  if (setup.type == kToHost && type == kStringDescriptor)
    return string_descriptor(setup.value & 0xFF);
  const bool known =
      setup.type == (kToHost | kOfInterface) && setup.index < shape_.interfaces.size();
  if (!known || shape_.interfaces[setup.index].code != kHidClass) return std::nullopt;
  const InterfaceShape& interface = shape_.interfaces[setup.index];
  if (type == kReportDescriptor) return interface.report_descriptor;
  if (type == kHidDescriptor) return hid_descriptor(interface);
  return std::nullopt;
}

std::optional<Bytes> Gadget::control(const SetupPacket& setup, std::span<const Byte> data) {
  constexpr std::uint8_t kNotStandard = 0x60;
  if ((setup.type & kNotStandard) != 0) return handle_control(setup, data);
  switch (setup.request) {
    case kGetDescriptor:
      return descriptor(setup);
    case kGetStatus:
      return Bytes{Byte{halted(low(setup.index)) && setup.type == (kToHost | kOfEndpoint)}, 0};
    case kGetConfiguration:
      return Bytes{1};
    case kClearFeature:
      if (setup.type == kOfEndpoint) clear_halt(low(setup.index));
      return Bytes{};
    case kSetFeature:
    case kSetConfiguration:
    case kSetInterface:
      return Bytes{};
    default:
      return std::nullopt;
  }
}

}  // namespace hedgehog::emulator
