// SPDX-License-Identifier: MIT
#include "daemon/device/usb/usb_handle.h"

#include <optional>
#include <span>

namespace hedgehog::device {
namespace {

using Endpoints = UsbHandle::Endpoints;

Endpoints endpoints_of(const libusb_interface_descriptor& setting, libusb_transfer_type type) {
  Endpoints found{setting.bInterfaceNumber, setting.bAlternateSetting};
  for (const auto& endpoint : std::span(setting.endpoint, setting.bNumEndpoints)) {
    if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != type) continue;
    const bool in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN;
    unsigned char& place = in ? found.in : found.out;
    if (place == 0) place = endpoint.bEndpointAddress;
  }
  return found;
}

std::optional<Endpoints> find_endpoints(libusb_device* device, int interface,
                                        libusb_transfer_type type, bool both) {
  libusb_config_descriptor* config = nullptr;
  if (libusb_get_active_config_descriptor(device, &config) != 0) return std::nullopt;
  std::optional<Endpoints> found;
  for (const auto& candidate : std::span(config->interface, config->bNumInterfaces)) {
    for (const auto& setting :
         std::span(candidate.altsetting, static_cast<std::size_t>(candidate.num_altsetting))) {
      const Endpoints endpoints = endpoints_of(setting, type);
      const bool wanted = interface < 0 || setting.bInterfaceNumber == interface;
      if (!found && wanted && endpoints.in != 0 && (!both || endpoints.out != 0)) found = endpoints;
    }
  }
  libusb_free_config_descriptor(config);
  return found;
}

}  // namespace

std::string usb_failure(int error) {
  switch (error) {
    case LIBUSB_ERROR_ACCESS:
      return "no permission to open it; the udev rule gives it to the group hedgehog";
    case LIBUSB_ERROR_BUSY:
      return "another program has it";
    case LIBUSB_ERROR_NO_DEVICE:
      return "it was disconnected";
    case LIBUSB_ERROR_NOT_SUPPORTED:
      return "it has not the endpoints that are needed";
    default:
      return libusb_strerror(error);
  }
}

std::unique_ptr<UsbHandle> UsbHandle::open(const UsbPlace& place, libusb_transfer_type type,
                                           bool both, std::string& failure) {
  std::unique_ptr<UsbHandle> made(new UsbHandle);
  if (const int error = libusb_init(&made->context_); error != 0) {
    failure = usb_failure(error);
    return nullptr;
  }
  libusb_device** list = nullptr;
  const auto count = libusb_get_device_list(made->context_, &list);
  int error = LIBUSB_ERROR_NO_DEVICE;
  for (libusb_device* device : std::span(list, count > 0 ? static_cast<std::size_t>(count) : 0)) {
    if (libusb_get_bus_number(device) != place.bus ||
        libusb_get_device_address(device) != place.address)
      continue;
    const auto endpoints = find_endpoints(device, place.interface, type, both);
    error = endpoints ? libusb_open(device, &made->handle_) : LIBUSB_ERROR_NOT_SUPPORTED;
    if (endpoints) made->endpoints_ = *endpoints;
  }
  if (list != nullptr) libusb_free_device_list(list, 1);
  if (error == 0) {
    (void)libusb_set_auto_detach_kernel_driver(made->handle_, 1);
    error = libusb_claim_interface(made->handle_, made->endpoints_.interface);
    made->claimed_ = error == 0;
  }
  if (error == 0 && made->endpoints_.alternate != 0) {
    error = libusb_set_interface_alt_setting(made->handle_, made->endpoints_.interface,
                                             made->endpoints_.alternate);
  }
  if (error != 0) {
    failure = usb_failure(error);
    return nullptr;
  }
  return made;
}

UsbHandle::~UsbHandle() {
  if (claimed_) (void)libusb_release_interface(handle_, endpoints_.interface);
  if (handle_ != nullptr) libusb_close(handle_);
  if (context_ != nullptr) libusb_exit(context_);
}

}  // namespace hedgehog::device
