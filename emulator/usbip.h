// SPDX-License-Identifier: MIT
// USB/IP wire format between a remote host and a device. Source: Linux,
// Documentation/usb/usbip_protocol.rst, version 1.1.1. Big endian. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::emulator {

using device::Byte;
using Bytes = std::vector<Byte>;

void put_u16(Bytes& to, std::uint32_t value);
void put_u32(Bytes& to, std::uint32_t value);

/// Status of a transfer, as a negative errno of Linux on any platform.
inline constexpr std::int32_t kTransferDone = 0;
inline constexpr std::int32_t kTransferStalled = -32;
inline constexpr std::int32_t kTransferTooLong = -75;
inline constexpr std::int32_t kTransferUnlinked = -104;

/// Length of the header of every transfer message, both directions.
inline constexpr std::size_t kTransferHead = 48;

/// A message of the host after a device is imported.
struct HostMessage {
  enum class Kind : std::uint8_t { kSubmit = 1, kUnlink = 2 };
  Kind kind = Kind::kSubmit;
  std::uint32_t sequence = 0;
  bool in = false;
  std::uint8_t endpoint = 0;
  /// Of the transfer; for OUT so many bytes follow the header.
  std::uint32_t length = 0;
  std::array<Byte, 8> setup{};
  /// Sequence number of the transfer cancelled by kUnlink.
  std::uint32_t victim = 0;
};

/// REQUIRES: kTransferHead bytes. nullopt: not a host message, an invalid endpoint, or longer than
/// kLongestTransfer.
std::optional<HostMessage> decode_host_message(std::span<const Byte> head);
inline constexpr std::uint32_t kLongestTransfer = 65536;

/// Responses of the device. `data` only for an IN transfer.
Bytes encode_submitted(std::uint32_t sequence, std::int32_t status, std::uint32_t actual,
                       std::span<const Byte> data = {});
Bytes encode_unlinked(std::uint32_t sequence, std::int32_t status);

/// Before a device is imported: a header of eight bytes; for an import followed by the bus id.
inline constexpr std::size_t kOperationHead = 8;
inline constexpr std::size_t kBusId = 32;
enum class Operation : std::uint16_t { kImport = 0x8003, kList = 0x8005 };
/// REQUIRES: kOperationHead bytes.
std::optional<Operation> decode_operation(std::span<const Byte> head);

/// A device as described in lists and imports.
struct Exported {
  std::string bus_id;  // "1-3"
  std::uint32_t bus = 1;
  std::uint32_t address = 0;
  std::uint32_t speed = 2;  // full
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t release = 0x0100;
  struct Interface {
    std::uint8_t code = 0;
    std::uint8_t subclass = 0;
    std::uint8_t protocol = 0;
  };
  std::vector<Interface> interfaces;
};

Bytes encode_list(std::span<const Exported> devices);
/// `device` null: no such device.
Bytes encode_import(const Exported* device);

}  // namespace hedgehog::emulator
