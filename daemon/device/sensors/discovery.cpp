// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/discovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace hedgehog::device {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  // A stream iterator would throw on a read error, as with a device that was just unplugged.
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Without the trailing newline.
std::string read_line(const fs::path& file) {
  std::string text = read_text(file);
  text.resize(std::min(text.size(), text.find('\n')));
  return text;
}

std::optional<int> number(std::string_view text, int base) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored))
    found.push_back(it->path());
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<UsbPlace> place_of(const fs::path& device) {
  const auto bus = number(read_line(device / "busnum"), 10);
  const auto address = number(read_line(device / "devnum"), 10);
  if (!bus || !address) return std::nullopt;
  return UsbPlace{*bus, *address, -1};
}

UsbInterface usb_interface(const fs::path& entry) {
  const auto byte = [&](const char* file) {
    return static_cast<std::uint8_t>(number(read_line(entry / file), 16).value_or(0));
  };
  return {byte("bInterfaceNumber"), byte("bInterfaceClass"), byte("bInterfaceSubClass"),
          byte("bInterfaceProtocol")};
}

/// "HID_NAME=..." of a uevent file.
std::string property(const std::string& uevent, const std::string& key) {
  const std::size_t at = ("\n" + uevent).find("\n" + key + "=");
  if (at == std::string::npos) return {};
  const std::size_t from = at + key.size() + 1;
  return uevent.substr(from, uevent.find('\n', from) - from);
}

constexpr int kUsbBus = 0x03;
constexpr int kBluetoothBus = 0x05;

std::optional<HidDevice> read_hid_device(const fs::path& entry) {
  // "0003:054C:0CE6.0007": bus, vendor, product, sequence number.
  const std::string id = entry.filename().string();
  if (id.size() < 14) return std::nullopt;
  const auto bus = number(std::string_view(id).substr(0, 4), 16);
  const auto vendor = number(std::string_view(id).substr(5, 4), 16);
  const auto product = number(std::string_view(id).substr(10, 4), 16);
  if (!bus || !vendor || !product) return std::nullopt;

  HidDevice made;
  made.vendor = static_cast<std::uint16_t>(*vendor);
  made.product = static_cast<std::uint16_t>(*product);
  made.bluetooth = *bus == kBluetoothBus;
  const std::string uevent = read_text(entry / "uevent");
  made.name = property(uevent, "HID_NAME");
  made.serial = property(uevent, "HID_UNIQ");
  const std::string descriptor = read_text(entry / "report_descriptor");
  made.descriptor.assign(descriptor.begin(), descriptor.end());
  const auto nodes = entries(entry / "hidraw");
  if (!nodes.empty()) made.hidraw = "/dev/" + nodes.front().filename().string();

  std::error_code error;
  const fs::path real = fs::canonical(entry, error);
  if (*bus == kUsbBus && !error) {
    const fs::path interface = real.parent_path();
    const auto index = number(read_line(interface / "bInterfaceNumber"), 16);
    made.usb = place_of(interface.parent_path());
    if (made.usb) made.usb->interface = index.value_or(0);
  }
  return made;
}

std::string named(const std::string& name, std::uint16_t vendor, std::uint16_t product) {
  return (name.empty() ? "device" : name) + " (" + usb_ids(vendor, product) + ")";
}

}  // namespace

std::vector<UsbDevice> list_usb(const std::string& sys) {
  std::vector<UsbDevice> devices;
  for (const fs::path& entry : entries(fs::path(sys) / "bus/usb/devices")) {
    const std::string name = entry.filename().string();
    // "1-3:1.0" is an interface of "1-3", which sorts before it.
    if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
      const auto owner = std::find_if(devices.begin(), devices.end(), [&](const UsbDevice& d) {
        return d.port == name.substr(0, colon);
      });
      if (owner != devices.end()) owner->interfaces.push_back(usb_interface(entry));
      continue;
    }
    const auto vendor = number(read_line(entry / "idVendor"), 16);
    const auto product = number(read_line(entry / "idProduct"), 16);
    const auto place = place_of(entry);
    if (!vendor || !product || !place) continue;
    devices.push_back({*place,
                       static_cast<std::uint16_t>(*vendor),
                       static_cast<std::uint16_t>(*product),
                       read_line(entry / "manufacturer"),
                       read_line(entry / "product"),
                       read_line(entry / "serial"),
                       name,
                       read_line(entry / "bcdDevice"),
                       {}});
  }
  return devices;
}

std::vector<HidDevice> list_hid(const std::string& sys) {
  std::vector<HidDevice> devices;
  for (const fs::path& entry : entries(fs::path(sys) / "bus/hid/devices"))
    if (auto device = read_hid_device(entry)) devices.push_back(std::move(*device));
  return devices;
}

std::string usb_ids(std::uint16_t vendor, std::uint16_t product) {
  return fmt::format("{:04x}:{:04x}", vendor, product);
}

std::string describe(const HidDevice& device) {
  return named(device.name, device.vendor, device.product);
}
std::string describe(const UsbDevice& device) {
  return named(device.name, device.vendor, device.product);
}

}  // namespace hedgehog::device
