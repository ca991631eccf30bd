// SPDX-License-Identifier: MIT
// A claimed interface of a USB device, over libusb. Used by the ports only.
#pragma once

#include <libusb-1.0/libusb.h>

#include <memory>
#include <string>

#include "daemon/device/sensors/discovery.h"

namespace hedgehog::device {

/// Reason of a libusb error: a clause for a sentence. A missing permission and a device in use by
/// another program are distinguished from all other errors.
std::string usb_failure(int error);

/// Owns a context, a handle and a claim. A separate context, because one that is older than the
/// device does not detect it without udevd.
class UsbHandle {
 public:
  UsbHandle(const UsbHandle&) = delete;
  UsbHandle& operator=(const UsbHandle&) = delete;
  ~UsbHandle();

  /// Endpoints of one direction each; 0: none.
  struct Endpoints {
    int interface = -1;
    int alternate = 0;
    unsigned char in = 0;
    unsigned char out = 0;
  };

  /// Opens the device at `place` and claims the first interface (or `place.interface`, if it is not
  /// negative) with an IN endpoint of `type`, and an OUT one too if `both`. Kernel drivers are
  /// detached meanwhile. Null on failure, with the reason in `failure`.
  static std::unique_ptr<UsbHandle> open(const UsbPlace& place, libusb_transfer_type type,
                                         bool both, std::string& failure);

  libusb_context* context() const noexcept { return context_; }
  libusb_device_handle* get() const noexcept { return handle_; }
  const Endpoints& endpoints() const noexcept { return endpoints_; }

 private:
  UsbHandle() = default;

  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
  Endpoints endpoints_;
  bool claimed_ = false;
};

}  // namespace hedgehog::device
