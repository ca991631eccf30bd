// SPDX-License-Identifier: MIT
// The seam between sensors and the operating system. Above it are the sensors, tested against fake
// ports; below it hidapi and libusb, thin. Used by one thread, the sensor's reader.
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

/// Reports of a HID device. The first byte of what is written and of features is the report's id, 0
/// when the device uses none.
class HidPort {
 public:
  HidPort() = default;
  HidPort(const HidPort&) = delete;
  HidPort& operator=(const HidPort&) = delete;
  virtual ~HidPort() = default;

  /// The next input report, with its id in front only if the device uses ids: its length, 0 when
  /// none came within `wait`, nothing when the device is gone.
  virtual std::optional<std::size_t> read(std::span<Byte> report,
                                          std::chrono::milliseconds wait) = 0;
  virtual bool write(std::span<const Byte> report) = 0;
  /// `report[0]` says which. The length that came, 0 for none.
  virtual std::size_t get_feature(std::span<Byte> report) = 0;
  virtual bool send_feature(std::span<const Byte> report) = 0;
};

/// A stream of bytes both ways.
class BytePort {
 public:
  BytePort() = default;
  BytePort(const BytePort&) = delete;
  BytePort& operator=(const BytePort&) = delete;
  virtual ~BytePort() = default;

  /// As HidPort::read.
  virtual std::optional<std::size_t> read(std::span<Byte> bytes,
                                          std::chrono::milliseconds wait) = 0;
  virtual bool write(std::span<const Byte> bytes) = 0;
};

/// What became of opening: a port, or a sentence why not.
struct OpenedHid {
  std::unique_ptr<HidPort> port;
  std::string failure;
  /// What it is, for people: "DualSense Wireless Controller (054c:0ce6)".
  std::string name;
  std::vector<Byte> descriptor;
  bool bluetooth = false;
};
struct OpenedBytes {
  std::unique_ptr<BytePort> port;
  std::string failure;
  std::string name;
};

/// Looks for the device and opens it; called again and again while it is not there.
using OpenHid = std::function<OpenedHid()>;
using OpenBytes = std::function<OpenedBytes()>;

}  // namespace hedgehog::device
