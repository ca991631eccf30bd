// SPDX-License-Identifier: MIT
// The ports of vhci-hcd, the kernel's USB controller whose devices hang on sockets. Needs root and
// the module. Source: Linux, drivers/usb/usbip/vhci_sysfs.c.
#pragma once

#include <string>

namespace hedgehog::emulator {

class Vhci {
 public:
  /// `folder`: of its attach, detach and status files.
  explicit Vhci(std::string folder = "/sys/devices/platform/vhci_hcd.0")
      : folder_(std::move(folder)) {}

  /// Gives the kernel its end of a stream socket (it takes a reference of its own) with a
  /// full-speed device behind it. The port. Throws std::runtime_error, std::system_error.
  int attach(int socket, unsigned device_id) const;
  /// Pulls the cable. Throws as `attach`.
  void detach(int port) const;

 private:
  int free_port() const;
  void write(const std::string& file, const std::string& text) const;

  std::string folder_;
};

}  // namespace hedgehog::emulator
