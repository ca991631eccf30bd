// SPDX-License-Identifier: MIT
// The threads below io: control, link, one per sensor, and the one that searches for the board on
// USB. The set of threads depends on the configuration and on --speed.
#pragma once

#include <memory>
#include <optional>

#include "daemon/config/config.h"
#include "daemon/control/loop/lockstep_loop.h"
#include "daemon/control/loop/loop.h"
#include "daemon/control/mailbox.h"
#include "daemon/control/recording/flight_recorder.h"
#include "daemon/control/state/control_settings.h"
#include "daemon/device/link_port.h"
#include "daemon/device/link_thread.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/device/simulator/simulated_board_process.h"
#include "daemon/device/usb/usb_board.h"
#include "daemon/sensors.h"

namespace hedgehog::daemon {

/// Made, started and stopped by one thread. Board and link run from the constructor on, the control
/// loop from `loop().start()`.
class DeviceThreads {
 public:
  /// `start_c`: temperature of the simulated ball. With `pace` it runs in lock-step. Throws
  /// std::system_error.
  DeviceThreads(const config::Config& config, const control::ControlSettings& settings,
                double start_c, std::optional<control::Pace> pace);

  control::Loop& loop() noexcept { return *loop_; }
  control::Mailbox& mailbox() noexcept { return *mailbox_; }
  device::LinkPort& port() noexcept { return *port_; }
  control::FlightRecorder& recorder() noexcept { return recorder_; }
  Sensors& sensors() noexcept { return *sensors_; }

 private:
  std::unique_ptr<device::Transport> make_board(const config::Config& config, double start_c);
  std::unique_ptr<device::SteppedBoard> make_stepped_board(const config::Config& config,
                                                           double start_c);
  std::unique_ptr<device::SocketTransport> start_board_process(const config::Config& config,
                                                               double start_c, bool in_step);

  std::unique_ptr<control::Mailbox> mailbox_;
  std::unique_ptr<device::LinkPort> port_;
  control::FlightRecorder recorder_;
  // Destroyed in reverse order: the link sends its last frame to a board that still runs.
  std::unique_ptr<device::SimulatedBoardProcess> board_process_;
  std::unique_ptr<device::UsbBoard> usb_board_;
  std::unique_ptr<device::LinkThread> link_;
  std::unique_ptr<control::Loop> loop_;
  std::unique_ptr<Sensors> sensors_;
};

}  // namespace hedgehog::daemon
