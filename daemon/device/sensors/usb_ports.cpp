// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/usb_ports.h"

#include <algorithm>
#include <utility>

#include "daemon/device/usb/usb_handle.h"

namespace hedgehog::device {
namespace {

// HID 1.11 section 7.2.
constexpr std::uint8_t kFromInterface = 0xA1;  // class, interface
constexpr std::uint8_t kToInterface = 0x21;
constexpr std::uint8_t kGetReport = 0x01;
constexpr std::uint8_t kSetReport = 0x09;
constexpr std::uint16_t kOutput = 2;
constexpr std::uint16_t kFeature = 3;
constexpr unsigned kControlMs = 500;
constexpr unsigned kWriteMs = 100;

/// The length, 0 after a timeout, nullopt if the device is disconnected.
std::optional<std::size_t> outcome(libusb_device_handle* handle, unsigned char endpoint, int error,
                                   int length) {
  if (error == 0 || error == LIBUSB_ERROR_TIMEOUT || error == LIBUSB_ERROR_INTERRUPTED ||
      error == LIBUSB_ERROR_OVERFLOW)
    return length > 0 && error != LIBUSB_ERROR_OVERFLOW ? static_cast<std::size_t>(length) : 0;
  if (error == LIBUSB_ERROR_PIPE && libusb_clear_halt(handle, endpoint) == 0) return 0;
  return std::nullopt;
}

class UsbHidPort : public HidPort {
 public:
  explicit UsbHidPort(std::unique_ptr<UsbHandle> usb) : usb_(std::move(usb)) {}

  std::optional<std::size_t> read(std::span<Byte> report, std::chrono::milliseconds wait) override {
    int length = 0;
    const unsigned char endpoint = usb_->endpoints().in;
    const int error = libusb_interrupt_transfer(
        usb_->get(), endpoint, report.data(), static_cast<int>(report.size()), &length,
        static_cast<unsigned>(std::max<std::int64_t>(wait.count(), 1)));
    return outcome(usb_->get(), endpoint, error, length);
  }

  bool write(std::span<const Byte> report) override { return set(kOutput, report); }
  bool send_feature(std::span<const Byte> report) override { return set(kFeature, report); }

  std::size_t get_feature(std::span<Byte> report) override {
    const bool plain = report[0] == 0;
    const auto body = report.subspan(plain ? 1 : 0);
    const int length =
        libusb_control_transfer(usb_->get(), kFromInterface, kGetReport,
                                static_cast<std::uint16_t>(kFeature << 8 | report[0]), interface(),
                                body.data(), static_cast<std::uint16_t>(body.size()), kControlMs);
    return length <= 0 ? 0 : static_cast<std::size_t>(length) + (plain ? 1 : 0);
  }

 private:
  std::uint16_t interface() const {
    return static_cast<std::uint16_t>(usb_->endpoints().interface);
  }

  bool set(std::uint16_t type, std::span<const Byte> report) {
    const auto body = report.subspan(report[0] == 0 ? 1 : 0);
    // libusb does not modify data to send.
    auto* bytes = const_cast<Byte*>(body.data());
    return libusb_control_transfer(usb_->get(), kToInterface, kSetReport,
                                   static_cast<std::uint16_t>(type << 8 | report[0]), interface(),
                                   bytes, static_cast<std::uint16_t>(body.size()), kControlMs) >= 0;
  }

  std::unique_ptr<UsbHandle> usb_;
};

class UsbBytePort : public BytePort {
 public:
  explicit UsbBytePort(std::unique_ptr<UsbHandle> usb) : usb_(std::move(usb)) {}

  /// REQUIRES: a multiple of 512 bytes, the largest packet of a bulk endpoint.
  std::optional<std::size_t> read(std::span<Byte> bytes, std::chrono::milliseconds wait) override {
    return transfer(usb_->endpoints().in, bytes.data(), bytes.size(),
                    static_cast<unsigned>(std::max<std::int64_t>(wait.count(), 1)));
  }

  bool write(std::span<const Byte> bytes) override {
    auto* data = const_cast<Byte*>(bytes.data());
    return transfer(usb_->endpoints().out, data, bytes.size(), kWriteMs).has_value();
  }

 private:
  std::optional<std::size_t> transfer(unsigned char endpoint, Byte* bytes, std::size_t size,
                                      unsigned wait_ms) {
    int length = 0;
    const int error = libusb_bulk_transfer(usb_->get(), endpoint, bytes, static_cast<int>(size),
                                           &length, wait_ms);
    return outcome(usb_->get(), endpoint, error, length);
  }

  std::unique_ptr<UsbHandle> usb_;
};

OpenedHid open_hid(const SensorDriver& driver, const std::string& serial) {
  const std::vector<HidDevice> devices = list_hid();
  const Found found = find_sensor(devices, driver, serial);
  if (!found.index) return {nullptr, found.failure, {}, {}, false};
  const HidDevice& device = devices[*found.index];
  if (!device.hidraw.empty()) return open_hidraw(device);
  if (device.usb) return open_usb_hid(device);
  return {nullptr, describe(device) + ": the kernel gives no way to read it", {}, {}, false};
}

OpenedBytes open_usb(const SensorDriver& driver, const std::string& serial) {
  const std::vector<UsbDevice> devices = list_usb();
  Found found = find_sensor(devices, driver, serial);
  if (found.index) return open_usb_bytes(devices[*found.index]);
  for (const UsbDevice& device : devices) {
    const SensorDriver* other = driver_of(device);
    if (other == nullptr || other->unusable.empty() || other->job != driver.job) continue;
    found.failure += "; " + describe(device) + ": " + std::string(other->unusable);
  }
  return {nullptr, found.failure, {}};
}

}  // namespace

OpenedHid open_usb_hid(const HidDevice& device) {
  OpenedHid opened{nullptr, {}, describe(device), device.descriptor, device.bluetooth};
  auto usb = UsbHandle::open(*device.usb, LIBUSB_TRANSFER_TYPE_INTERRUPT, false, opened.failure);
  if (usb)
    opened.port = std::make_unique<UsbHidPort>(std::move(usb));
  else
    opened.failure = opened.name + ": " + opened.failure;
  return opened;
}

OpenedBytes open_usb_bytes(const UsbDevice& device) {
  OpenedBytes opened{nullptr, {}, describe(device)};
  auto usb = UsbHandle::open(device.place, LIBUSB_TRANSFER_TYPE_BULK, true, opened.failure);
  if (usb)
    opened.port = std::make_unique<UsbBytePort>(std::move(usb));
  else
    opened.failure = opened.name + ": " + opened.failure;
  return opened;
}

std::unique_ptr<Sensor> make_sensor(const SensorDriver& driver, const std::string& serial,
                                    const SensorSinks& sinks) {
  if (driver.make_hid != nullptr)
    return driver.make_hid([&driver, serial] { return open_hid(driver, serial); }, sinks);
  return driver.make_usb([&driver, serial] { return open_usb(driver, serial); }, sinks);
}

}  // namespace hedgehog::device
