// SPDX-License-Identifier: MIT
// The readers of the sensors that configuration names, and what they say about themselves.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/control/loop.h"
#include "daemon/control/mailbox.h"
#include "daemon/device/sensors/sensor_thread.h"

namespace hedgehog::daemon {

/// One sensor as people see it.
struct SensorLine {
  std::string job;   // "imu", "thermometer"
  std::string type;  // as configured: "dualsense"
  device::SensorState state;
};

/// io thread. The readers run from the constructor on; mailbox and loop outlive it.
class Sensors {
 public:
  /// Throws std::system_error.
  Sensors(const config::Config& config, control::Mailbox& mailbox, const control::Loop& loop);

  std::vector<SensorLine> list() const;
  /// A sentence for each sensor that came, went, or is missing for another reason than before;
  /// looks twice a second at most.
  std::vector<std::string> news();

 private:
  struct Reader {
    SensorLine line;
    std::unique_ptr<device::SensorThread> thread;
  };
  void add(const std::string& job, const std::string& type, std::unique_ptr<device::Sensor> sensor);

  std::vector<Reader> readers_;
  std::chrono::steady_clock::time_point looked_{};
};

}  // namespace hedgehog::daemon
