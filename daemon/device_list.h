// SPDX-License-Identifier: MIT
// device.list: devices on the buses, the use of each, or the reason for being unused.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/device/sensors/drivers.h"
#include "daemon/device/usb/board_finder.h"
#include "daemon/sensors.h"
#include "daemon/server/device/device_scanner.h"
#include "daemon/server/disk/disk_thread.h"
#include "protocol/methods.h"

namespace hedgehog::daemon {

/// The daemon's own information on its devices.
struct DeviceFacts {
  device::BoardIds board_ids;
  /// nullopt: the board is simulated.
  std::optional<device::BoardUsbInfo> board;
  std::string imu_type = "none";
  std::string imu_serial;
  std::string thermometer_serial;
  /// Result of `Sensors::list`.
  std::vector<SensorLine> lines;
};

/// Any thread.
protocol::DevicesResult seen_devices(const std::vector<device::UsbDevice>& usb,
                                     const std::vector<device::HidDevice>& hid,
                                     const DeviceFacts& facts);

/// io thread; scans on `scan_thread`, which may hang. The references outlive it.
class DeviceList final : public server::DeviceScanner {
 public:
  DeviceList(const config::Config& config, const Sensors& sensors, server::DiskThread& scan_thread)
      : config_(config), sensors_(sensors), scan_thread_(scan_thread) {}
  Ready scan() override;

 private:
  const config::Config& config_;
  const Sensors& sensors_;
  server::DiskThread& scan_thread_;
};

}  // namespace hedgehog::daemon
