// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/drivers.h"

#include <algorithm>
#include <array>

namespace hedgehog::device {
namespace {

// From the general to the specific; the configuration lists them in this order.
constexpr std::array<const SensorDriver*, 6> kDrivers{&kHidSensorDriver,  &kDualSenseDriver,
                                                      &kDualShock4Driver, &kClosedXsensDriver,
                                                      &kMtiDriver,        &kTemperDriver};

template <class Matches>
const SensorDriver* last_match(Matches matches) {
  const auto found = std::find_if(kDrivers.rbegin(), kDrivers.rend(), matches);
  return found == kDrivers.rend() ? nullptr : *found;
}

template <class Device>
Found find_one(const std::vector<Device>& devices, const SensorDriver& driver,
               const std::string& serial) {
  Found found;
  std::size_t others = 0;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (driver_of(devices[i]) != &driver) continue;
    if (!serial.empty() && devices[i].serial != serial) {
      ++others;
      continue;
    }
    if (found.index) {
      return {std::nullopt, "two of them are connected, " + describe(devices[*found.index]) +
                                " and " + describe(devices[i]) +
                                "; the setting `serial` says which"};
    }
    found.index = i;
  }
  if (!found.index) {
    found.failure = "no " + std::string(driver.words) +
                    (serial.empty() ? " is connected" : " with serial number " + serial);
    if (others > 0) found.failure += ", only with others";
  }
  return found;
}

}  // namespace

std::span<const SensorDriver* const> sensor_drivers() noexcept { return kDrivers; }

const SensorDriver* driver_of(const HidDevice& device) {
  return last_match([&device](const SensorDriver* driver) {
    return driver->matches_hid != nullptr && driver->matches_hid(device);
  });
}
const SensorDriver* driver_of(const UsbDevice& device) {
  return last_match([&device](const SensorDriver* driver) {
    return driver->matches_usb != nullptr && driver->matches_usb(device);
  });
}

Found find_sensor(const std::vector<HidDevice>& devices, const SensorDriver& driver,
                  const std::string& serial) {
  return find_one(devices, driver, serial);
}
Found find_sensor(const std::vector<UsbDevice>& devices, const SensorDriver& driver,
                  const std::string& serial) {
  return find_one(devices, driver, serial);
}

}  // namespace hedgehog::device
