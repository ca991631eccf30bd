// SPDX-License-Identifier: MIT
// HID reports through hidapi's hidraw backend.
#include <hidapi/hidapi.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <utility>

#include "daemon/device/sensors/usb_ports.h"

namespace hedgehog::device {
namespace {

struct Close {
  void operator()(hid_device* device) const noexcept { hid_close(device); }
};

class HidrawPort : public HidPort {
 public:
  explicit HidrawPort(hid_device* device) : device_(device) {}

  std::optional<std::size_t> read(std::span<Byte> report, std::chrono::milliseconds wait) override {
    const int length = hid_read_timeout(device_.get(), report.data(), report.size(),
                                        static_cast<int>(wait.count()));
    if (length < 0) return std::nullopt;
    return static_cast<std::size_t>(length);
  }
  bool write(std::span<const Byte> report) override {
    return hid_write(device_.get(), report.data(), report.size()) >= 0;
  }
  std::size_t get_feature(std::span<Byte> report) override {
    const int length = hid_get_feature_report(device_.get(), report.data(), report.size());
    return length < 0 ? 0 : static_cast<std::size_t>(length);
  }
  bool send_feature(std::span<const Byte> report) override {
    return hid_send_feature_report(device_.get(), report.data(), report.size()) >= 0;
  }

 private:
  std::unique_ptr<hid_device, Close> device_;
};

}  // namespace

OpenedHid open_hidraw(const HidDevice& device) {
  OpenedHid opened{nullptr, {}, describe(device), device.descriptor, device.bluetooth};
  if (access(device.hidraw.c_str(), R_OK | W_OK) != 0) {
    opened.failure = opened.name + ": " + device.hidraw + ": " + std::strerror(errno);
    if (errno == EACCES) opened.failure += "; the udev rule gives it to the group hedgehog";
    return opened;
  }
  // Each opening replaces the text of hidapi's last error, which all threads share.
  static std::mutex opening;
  const std::lock_guard lock(opening);
  if (hid_device* handle = hid_open_path(device.hidraw.c_str()))
    opened.port = std::make_unique<HidrawPort>(handle);
  else
    opened.failure = opened.name + ": " + device.hidraw + " cannot be opened";
  return opened;
}

}  // namespace hedgehog::device
