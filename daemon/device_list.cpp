// SPDX-License-Identifier: MIT
#include "daemon/device_list.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "daemon/device/usb/board_choice.h"

namespace hedgehog::daemon {
namespace {

using device::SensorDriver;
using protocol::SeenDevice;

constexpr std::uint8_t kHubClass = 0x09;

std::optional<std::string> given(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Removes the name of that device: "Pad (054c:0ce6): no permission" gives "no permission".
std::string without_name(const std::string& what, const std::string& name) {
  return what.starts_with(name + ": ") ? what.substr(name.size() + 2) : what;
}

class BusScan {
 public:
  explicit BusScan(const DeviceFacts& facts) : facts_(facts) {}

  void note(const device::UsbDevice& usb, const std::vector<device::HidDevice>& hid) {
    const SensorDriver* driver = driver_of(usb);
    std::string name = device::describe(usb);
    for (const device::HidDevice& one : hid) {
      const bool same = one.usb && one.usb->bus == usb.place.bus &&
                        one.usb->address == usb.place.address && driver_of(one) != nullptr;
      if (!same) continue;
      driver = driver_of(one);
      name = device::describe(one);
    }
    SeenDevice seen{"USB " + usb.port,
                    device::usb_ids(usb.vendor, usb.product),
                    usb.name,
                    given(usb.serial),
                    given(device::firmware_of(usb)),
                    {},
                    {},
                    {}};
    if (is_board(usb, facts_.board_ids)) {
      classify_board(usb, seen);
    } else if (driver != nullptr) {
      classify_sensor(*driver, name, seen);
    } else if (const SensorLine* line = open_line(seen)) {
      use_for(*line, seen);
    } else {
      const bool hub = std::any_of(usb.interfaces.begin(), usb.interfaces.end(),
                                   [](const auto& one) { return one.category == kHubClass; });
      result_.others += hub || usb.port.starts_with("usb") ? 0 : 1;
      return;
    }
    result_.devices.push_back(std::move(seen));
  }

  void note(const device::HidDevice& hid) {
    if (hid.usb) return;
    const SensorDriver* driver = driver_of(hid);
    if (driver == nullptr) {
      ++result_.others;
      return;
    }
    SeenDevice seen{hid.bluetooth ? "Bluetooth" : "HID",
                    device::usb_ids(hid.vendor, hid.product),
                    hid.name,
                    given(hid.serial),
                    {},
                    {},
                    {},
                    {}};
    classify_sensor(*driver, device::describe(hid), seen);
    result_.devices.push_back(std::move(seen));
  }

  protocol::DevicesResult finish() {
    for (const SensorLine& line : facts_.lines) {
      const bool listed = std::any_of(listed_types_.begin(), listed_types_.end(),
                                      [&](const std::string& type) { return type == line.type; });
      if (!line.state.open && !listed) result_.missing.push_back({line.job, line.state.what});
    }
    return std::move(result_);
  }

 private:
  void classify_board(const device::UsbDevice& usb, SeenDevice& seen) {
    listed_types_.emplace_back("usb");
    if (const auto version = device::frame_version(usb)) seen.protocol = std::to_string(*version);
    if (!facts_.board)
      seen.why_not = "the ball is simulated (backend in the configuration)";
    else if (facts_.board->open && facts_.board->place == usb.place)
      seen.use = "board";
    else if (facts_.board->open)
      seen.why_not = "another board is used";
    else
      seen.why_not = without_name(facts_.board->what, device::describe_board(usb));
  }

  /// The sensor line of this open device.
  const SensorLine* open_line(const SeenDevice& seen) const {
    for (const SensorLine& line : facts_.lines) {
      const std::string& serial = line.job == "imu" ? facts_.imu_serial : facts_.thermometer_serial;
      if (line.job != "board" && line.state.open &&
          line.state.what.find("(" + seen.ids + ")") != std::string::npos &&
          (serial.empty() || serial == seen.serial.value_or("")))
        return &line;
    }
    return nullptr;
  }
  void use_for(const SensorLine& line, SeenDevice& seen) {
    listed_types_.push_back(line.type);
    seen.use = line.job;
  }

  void classify_sensor(const SensorDriver& driver, const std::string& name, SeenDevice& seen) {
    if (seen.name.empty()) seen.name = driver.words;
    if (const SensorLine* line = open_line(seen)) {
      use_for(*line, seen);
      return;
    }
    const std::string type(driver.type);
    listed_types_.push_back(type);
    const auto wanted = std::find_if(facts_.lines.begin(), facts_.lines.end(),
                                     [&](const SensorLine& line) { return line.type == type; });
    if (!driver.unusable.empty()) {
      seen.why_not = driver.unusable;
    } else if (wanted != facts_.lines.end()) {
      seen.why_not =
          wanted->state.open ? "another one is used" : without_name(wanted->state.what, name);
    } else if (driver.job == device::SensorJob::kThermometer) {
      seen.why_not = "thermometer.type in the configuration is not \"" + type + "\"";
    } else {
      seen.why_not =
          "imu.type in the configuration is \"" + facts_.imu_type + "\", not \"" + type + "\"";
    }
  }

  const DeviceFacts& facts_;
  protocol::DevicesResult result_;
  /// Types with a listed device.
  std::vector<std::string> listed_types_;
};

}  // namespace

protocol::DevicesResult seen_devices(const std::vector<device::UsbDevice>& usb,
                                     const std::vector<device::HidDevice>& hid,
                                     const DeviceFacts& facts) {
  BusScan scan(facts);
  for (const device::UsbDevice& one : usb) scan.note(one, hid);
  for (const device::HidDevice& one : hid) scan.note(one);
  return scan.finish();
}

DeviceList::Ready DeviceList::scan() {
  struct Answer {
    std::atomic<bool> there{false};
    protocol::DevicesResult devices;
  };
  const auto answer = std::make_shared<Answer>();
  DeviceFacts facts{{config_.device.usb, config_.device.usb_serial},
                    sensors_.board(),
                    std::string(config::name(config_.imu)),
                    config_.imu_fitting.serial,
                    config_.thermometer.serial,
                    sensors_.list()};
  const bool taken = scan_thread_.post(server::DiskUse::kScan, [answer, facts = std::move(facts)] {
    answer->devices = seen_devices(device::list_usb(), device::list_hid(), facts);
    answer->there.store(true, std::memory_order_release);
  });
  if (!taken) return {};
  return [answer]() -> std::optional<protocol::DevicesResult> {
    if (!answer->there.load(std::memory_order_acquire)) return std::nullopt;
    return answer->devices;
  };
}

}  // namespace hedgehog::daemon
