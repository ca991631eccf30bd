// SPDX-License-Identifier: MIT
// Interface between sensors and the operating system: thin wrappers of hidapi and libusb, or fake
// ports of tests. Used by one thread, the sensor's.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

/// Reports of a HID device. The first byte of written reports and of features is the report's id, 0
/// if the device uses none.
class HidPort {
 public:
  HidPort() = default;
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;
  virtual ~HidPort() = default;

  /// Reads the next input report, with its id in front only if the device uses ids. Returns its
  /// length, 0 if none arrived within `wait`, nullopt if the device is disconnected.
  virtual std::optional<std::size_t> read(std::span<Byte> report,
                                          std::chrono::milliseconds wait) = 0;
  virtual bool write(std::span<const Byte> report) = 0;
  /// `report[0]` selects the report. Returns the received length, 0 for none.
  virtual std::size_t get_feature(std::span<Byte> report) = 0;
  virtual bool send_feature(std::span<const Byte> report) = 0;
};

/// A bidirectional stream of bytes.
class BytePort {
 public:
  BytePort() = default;
  BytePort(const BytePort&) = delete;
  BytePort& operator=(const BytePort&) = delete;
  virtual ~BytePort() = default;

  /// Like HidPort::read.
  virtual std::optional<std::size_t> read(std::span<Byte> bytes,
                                          std::chrono::milliseconds wait) = 0;
  virtual bool write(std::span<const Byte> bytes) = 0;
};

/// Result of opening: a port, or a sentence with the reason of the failure.
struct OpenedHid {
  std::unique_ptr<HidPort> port;
  std::string failure;
  std::string name;  // for display: "DualSense Wireless Controller (054c:0ce6)"
  std::vector<Byte> descriptor;
  bool bluetooth = false;
};
struct OpenedBytes {
  std::unique_ptr<BytePort> port;
  std::string failure;
  std::string name;
};

/// Finds the device and opens it; called repeatedly while it is not connected.
using OpenHid = std::function<OpenedHid()>;
using OpenBytes = std::function<OpenedBytes()>;

}  // namespace hedgehog::device
