// SPDX-License-Identifier: MIT
#include "emulator/usbip.h"

#include <algorithm>

namespace hedgehog::emulator {
namespace {

constexpr std::uint32_t kSubmitted = 3;
constexpr std::uint32_t kUnlinked = 4;
constexpr std::uint16_t kVersion = 0x0111;
constexpr std::uint16_t kListed = 0x0005;
constexpr std::uint16_t kImported = 0x0003;
constexpr std::size_t kPath = 256;
constexpr std::uint32_t kEndpoints = 16;

Bytes answer(std::uint32_t command, std::uint32_t sequence, std::int32_t status) {
  Bytes bytes;
  bytes.reserve(kTransferHead);
  put_u32(bytes, command);
  put_u32(bytes, sequence);
  // Device, direction and endpoint are 0 in responses: the host identifies them by sequence number.
  bytes.resize(20);
  put_u32(bytes, static_cast<std::uint32_t>(status));
  return bytes;
}

void put_text(Bytes& to, const std::string& text, std::size_t capacity) {
  const std::size_t end = to.size() + capacity;
  to.insert(to.end(), text.begin(),
            text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), capacity - 1)));
  to.resize(end);
}

void put_operation(Bytes& to, std::uint16_t code, std::uint32_t status) {
  put_u16(to, kVersion);
  put_u16(to, code);
  put_u32(to, status);
}

void put_device(Bytes& to, const Exported& device) {
  put_text(to, "/sys/devices/emulated/" + device.bus_id, kPath);
  put_text(to, device.bus_id, kBusId);
  for (const std::uint32_t number : {device.bus, device.address, device.speed}) put_u32(to, number);
  for (const std::uint32_t number : {device.vendor, device.product, device.release})
    put_u16(to, number);
  // Class, subclass and protocol are those of its interfaces; one configuration, number 1.
  to.insert(to.end(), {0, 0, 0, 1, 1, static_cast<Byte>(device.interfaces.size())});
}

}  // namespace

void put_u16(Bytes& to, std::uint32_t value) {
  to.push_back(static_cast<Byte>(value >> 8));
  to.push_back(static_cast<Byte>(value));
}

void put_u32(Bytes& to, std::uint32_t value) {
  put_u16(to, value >> 16);
  put_u16(to, value & 0xFFFF);
}

std::optional<HostMessage> decode_host_message(std::span<const Byte> head) {
  const auto word = [&head](std::size_t index) { return device::big_u32(&head[4 * index]); };
  HostMessage message;
  const std::uint32_t command = word(0);
  if (command != 1 && command != 2) return std::nullopt;
  message.kind = static_cast<HostMessage::Kind>(command);
  message.sequence = word(1);
  message.in = word(3) != 0;
  if (word(4) >= kEndpoints) return std::nullopt;
  message.endpoint = static_cast<std::uint8_t>(word(4));
  if (message.kind == HostMessage::Kind::kUnlink) {
    message.victim = word(5);
    return message;
  }
  message.length = word(6);
  if (message.length > kLongestTransfer) return std::nullopt;
  std::copy_n(head.begin() + 40, message.setup.size(), message.setup.begin());
  return message;
}

Bytes encode_submitted(std::uint32_t sequence, std::int32_t status, std::uint32_t actual,
                       std::span<const Byte> data) {
  Bytes bytes = answer(kSubmitted, sequence, status);
  put_u32(bytes, actual);
  bytes.resize(kTransferHead);
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

Bytes encode_unlinked(std::uint32_t sequence, std::int32_t status) {
  Bytes bytes = answer(kUnlinked, sequence, status);
  bytes.resize(kTransferHead);
  return bytes;
}

std::optional<Operation> decode_operation(std::span<const Byte> head) {
  const std::uint16_t code = device::big_u16(&head[2]);
  if (code == static_cast<std::uint16_t>(Operation::kList)) return Operation::kList;
  if (code == static_cast<std::uint16_t>(Operation::kImport)) return Operation::kImport;
  return std::nullopt;
}

Bytes encode_list(std::span<const Exported> devices) {
  Bytes bytes;
  put_operation(bytes, kListed, 0);
  put_u32(bytes, static_cast<std::uint32_t>(devices.size()));
  for (const Exported& device : devices) {
    put_device(bytes, device);
    for (const auto& interface : device.interfaces)
      bytes.insert(bytes.end(), {interface.code, interface.subclass, interface.protocol, 0});
  }
  return bytes;
}

Bytes encode_import(const Exported* device) {
  Bytes bytes;
  put_operation(bytes, kImported, device == nullptr ? 1 : 0);
  if (device != nullptr) put_device(bytes, *device);
  return bytes;
}

}  // namespace hedgehog::emulator
