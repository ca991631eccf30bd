// SPDX-License-Identifier: MIT
// device.list: which devices are there, what each is used for, and why the others are not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/device/sensors/discovery.h"
#include "daemon/device/usb/board_finder.h"
#include "daemon/sensors.h"
#include "daemon/server/device_looker.h"
#include "daemon/server/disk_thread.h"
#include "protocol/results.h"

namespace hedgehog::daemon {

/// What the daemon knows of its devices itself.
struct DeviceFacts {
  device::BoardIds board_ids;
  /// nullopt: the board is simulated.
  std::optional<device::BoardSight> board;
  std::string imu_type = "none";
  std::string imu_serial;
  std::string thermometer_serial;
  /// As `Sensors::list` says.
  std::vector<SensorLine> lines;
};

/// Any thread.
protocol::DevicesResult seen_devices(const std::vector<device::UsbDevice>& usb,
                                     const std::vector<device::HidDevice>& hid,
                                     const DeviceFacts& facts);

/// io thread; looks on `looker`, a thread that may hang. The references outlive it.
class DeviceList final : public server::DeviceLooker {
 public:
  DeviceList(const config::Config& config, const Sensors& sensors, server::DiskThread& looker)
      : config_(config), sensors_(sensors), looker_(looker) {}
  Ready look() override;

 private:
  const config::Config& config_;
  const Sensors& sensors_;
  server::DiskThread& looker_;
};

}  // namespace hedgehog::daemon
