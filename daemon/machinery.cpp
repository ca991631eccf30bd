// SPDX-License-Identifier: MIT
#include "daemon/machinery.h"

#include <cstdlib>
#include <utility>

#include "daemon/control/control_loop.h"
#include "daemon/control/lockstep_loop.h"
#include "daemon/device/socket_transport.h"

namespace hedgehog::daemon {
namespace {

/// For tests: where hedgehog-simboard writes what it did.
constexpr const char* kTraceVariable = "HEDGEHOG_SIMBOARD_TRACE";

device::SimulatedBoardOptions board_options(const config::Config& config, double start_c) {
  device::SimulatedBoardOptions options;
  const double noise_k = options.plant.sensor_noise_k;
  options.plant = model::PlantParameters::of(config.device.coils, config.device.thermal);
  options.plant.sensor_noise_k = noise_k;
  options.plant.force_slope_n_a = config.device.force_slope_n_a;
  options.plant.seed = config.simulator.seed;
  options.ambient_c = config.simulator.ambient_c;
  options.start_c = start_c;
  return options;
}

}  // namespace

Machinery::Machinery(const config::Config& config, const control::ControlSettings& settings,
                     double start_c, int speed)
    : mailbox_(std::make_unique<control::Mailbox>()), port_(std::make_unique<device::LinkPort>()) {
  if (speed > 1) {
    loop_ = std::make_unique<control::LockstepLoop>(settings, *mailbox_, *port_, &recorder_,
                                                    board_options(config, start_c), speed);
    sensors_ = std::make_unique<Sensors>(config, *mailbox_, *loop_);
    return;
  }
  std::unique_ptr<device::Transport> transport;
  if (config.simulator.process) {
    device::SimulatedBoardProcessOptions options;
    options.board = board_options(config, start_c);
    if (const char* trace = std::getenv(kTraceVariable)) {
      options.trace = trace;
    }
    board_process_ = std::make_unique<device::SimulatedBoardProcess>(options);
    transport = board_process_->take_transport();
  } else {
    auto [host, board] = device::make_socket_pair();
    board_thread_ = std::make_unique<device::SimulatedBoardThread>(
        board_options(config, start_c),
        std::make_unique<device::SocketTransport>(std::move(board)));
    transport = std::make_unique<device::SocketTransport>(std::move(host));
  }
  link_ = std::make_unique<device::LinkThread>(*port_, std::move(transport));
  loop_ = std::make_unique<control::ControlLoop>(settings, *mailbox_, *port_, &recorder_);
  sensors_ = std::make_unique<Sensors>(config, *mailbox_, *loop_);
}

}  // namespace hedgehog::daemon
