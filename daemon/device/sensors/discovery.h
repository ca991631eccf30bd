// SPDX-License-Identifier: MIT
// USB and HID devices of this machine as listed by the kernel in /sys: opens no device and needs no
// permission. Reads files; any thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

/// Address of a device, by which libusb finds it.
struct UsbPlace {
  int bus = 0;
  int address = 0;
  /// Interface of a HID device; -1: the whole device.
  int interface = -1;
  friend bool operator==(const UsbPlace&, const UsbPlace&) = default;
};

/// The first setting of an interface.
struct UsbInterface {
  int number = 0;
  std::uint8_t category = 0;  // bInterfaceClass
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;
};

struct UsbDevice {
  UsbPlace place;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string manufacturer;
  std::string name;
  std::string serial;
  /// "1-3": the port it is connected to, as named by the kernel.
  std::string port;
  /// bcdDevice, four digits: "0102" is 1.02.
  std::string release;
  std::vector<UsbInterface> interfaces;
};

struct HidDevice {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  bool bluetooth = false;
  std::string name;
  std::string serial;
  std::vector<Byte> descriptor;
  /// "/dev/hidraw3"; empty: the kernel creates no node (hid-sensor-hub before Linux 6.3).
  std::string hidraw;
  std::optional<UsbPlace> usb;
};

/// `sys`: "/sys", or a test's own tree. Sorted by port. Unreadable entries are omitted.
std::vector<UsbDevice> list_usb(const std::string& sys = "/sys");
std::vector<HidDevice> list_hid(const std::string& sys = "/sys");

/// Vendor and product id.
struct UsbIds {
  std::uint16_t vendor;
  std::uint16_t product;
};

/// True if the device has one of these ids. `Device` is a UsbDevice or a HidDevice.
template <class Device>
bool has_ids(const Device& device, std::span<const UsbIds> ids) {
  return std::any_of(
      ids.begin(), ids.end(),
      [&device](const UsbIds& one) {
        return one.vendor == device.vendor && one.product == device.product;
      });
}

/// "054c:0ce6".
std::string usb_ids(std::uint16_t vendor, std::uint16_t product);
/// "Wireless Controller (054c:0ce6)".
std::string describe(const HidDevice& device);
std::string describe(const UsbDevice& device);

}  // namespace hedgehog::device
