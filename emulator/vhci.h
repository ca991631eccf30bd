// SPDX-License-Identifier: MIT
// Ports of vhci-hcd, the kernel's virtual USB controller with devices on sockets. Needs root and
// the module. Source: Linux, drivers/usb/usbip/vhci_sysfs.c.
#pragma once

#include <string>

namespace hedgehog::emulator {

class Vhci {
 public:
  /// `folder`: contains its attach, detach and status files.
  explicit Vhci(std::string folder = "/sys/devices/platform/vhci_hcd.0")
      : folder_(std::move(folder)) {}

  /// Passes one end of a stream socket of a full-speed device to the kernel, which takes its own
  /// reference. Returns the port. Throws std::runtime_error, std::system_error.
  int attach(int socket, unsigned device_id) const;
  /// Unplugs the device. Throws as `attach`.
  void detach(int port) const;

 private:
  int free_port() const;
  void write(const std::string& file, const std::string& text) const;

  std::string folder_;
};

}  // namespace hedgehog::emulator
