// SPDX-License-Identifier: MIT
// Threads of the configured sensors, and the state of these and of the board on USB.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/control/loop/loop.h"
#include "daemon/control/mailbox.h"
#include "daemon/device/sensors/sensor_thread.h"
#include "daemon/device/usb/usb_board.h"
#include "daemon/server/device/device_view.h"

namespace hedgehog::daemon {

/// Displayed state of one sensor, or of the board.
struct SensorLine {
  std::string job;   // "board", "imu", "thermometer"
  std::string type;  // as configured: "dualsense"
  device::SensorState state;
};

/// io thread. The sensor threads run from the constructor on; mailbox, loop and board outlive it.
class Sensors {
 public:
  /// `board`: nullptr if it is simulated. Throws std::system_error.
  Sensors(const config::Config& config, control::Mailbox& mailbox, const control::Loop& loop,
          const device::UsbBoard* board);

  std::vector<SensorLine> list() const;
  /// A sentence for each sensor that was connected or disconnected, or is missing for another
  /// reason than before; checks twice a second at most.
  std::vector<std::string> messages();
  /// nullopt: simulated.
  std::optional<device::BoardUsbInfo> board() const;
  /// The part of it for clients.
  server::BoardInfo board_info() const;

 private:
  struct Reader {
    SensorLine line;
    std::unique_ptr<device::SensorThread> thread;  // nullptr: the board
  };
  device::SensorState state(const Reader& reader) const;
  /// Does nothing if `driver` is nullptr.
  void add(const std::string& job, const device::SensorDriver* driver, const std::string& serial,
           const device::SensorSinks& sinks);

  const device::UsbBoard* board_;
  std::vector<Reader> readers_;
  std::chrono::steady_clock::time_point looked_{};
};

}  // namespace hedgehog::daemon
