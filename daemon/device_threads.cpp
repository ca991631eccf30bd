// SPDX-License-Identifier: MIT
#include "daemon/device_threads.h"

#include <cstdlib>
#include <utility>

#include "daemon/control/loop/control_loop.h"
#include "daemon/device/simulator/process_lock_step.h"
#include "daemon/device/simulator/simulated_board_transport.h"
#include "daemon/device/usb/libusb_port.h"

namespace hedgehog::daemon {
namespace {

/// For tests: file for the trace of hedgehog-simboard.
constexpr const char* kTraceVariable = "HEDGEHOG_SIMBOARD_TRACE";

device::SimulatedBoardOptions board_options(const config::Config& config, double start_c) {
  device::SimulatedBoardOptions options;
  const double noise_k = options.plant.sensor_noise_k;
  const model::DeviceModel& ball = config.simulated_ball();
  options.plant = model::PlantParameters::of(ball.coils, ball.thermal);
  options.plant.sensor_noise_k = noise_k;
  options.plant.force_slope_n_a = ball.force_slope_n_a;
  options.plant.seed = config.simulator.seed;
  options.front_end = {config.simulator.front_end, config.simulator.thermistors.value_or(0),
                       config.simulator.seed};
  options.ambient_c = config.simulator.ambient_c;
  options.start_c = start_c;
  return options;
}

}  // namespace

DeviceThreads::DeviceThreads(const config::Config& config, const control::ControlSettings& settings,
                             double start_c, std::optional<control::Pace> pace)
    // The queues' memory is used as they fill; it need not be initialised.
    : mailbox_(std::make_unique_for_overwrite<control::Mailbox>()),
      port_(std::make_unique<device::LinkPort>()) {
  if (pace) {
    loop_ = std::make_unique<control::LockstepLoop>(settings, *mailbox_, *port_, &recorder_, *pace,
                                                    make_stepped_board(config, start_c));
    sensors_ = std::make_unique<Sensors>(config, *mailbox_, *loop_, usb_board_.get());
    return;
  }
  link_ = std::make_unique<device::LinkThread>(*port_, make_board(config, start_c));
  loop_ = std::make_unique<control::ControlLoop>(settings, *mailbox_, *port_, &recorder_);
  sensors_ = std::make_unique<Sensors>(config, *mailbox_, *loop_, usb_board_.get());
}

std::unique_ptr<device::Transport> DeviceThreads::make_board(const config::Config& config,
                                                             double start_c) {
  if (config.backend == config::Backend::kUsb) {
    usb_board_ = std::make_unique<device::UsbBoard>(
        device::make_libusb_bus(), device::BoardIds{config.device.usb, config.device.usb_serial});
    return usb_board_->transport();
  }
  if (config.simulator.process) return start_board_process(config, start_c, false);
  return std::make_unique<device::SimulatedBoardTransport>(board_options(config, start_c));
}

std::unique_ptr<device::SteppedBoard> DeviceThreads::make_stepped_board(
    const config::Config& config, double start_c) {
  if (config.simulator.process)
    return std::make_unique<device::ProcessLockStep>(*port_,
                                                     start_board_process(config, start_c, true));
  return std::make_unique<device::LockStep>(*port_, board_options(config, start_c));
}

std::unique_ptr<device::SocketTransport> DeviceThreads::start_board_process(
    const config::Config& config, double start_c, bool in_step) {
  device::SimulatedBoardProcessOptions options;
  options.board = board_options(config, start_c);
  options.in_step = in_step;
  if (const char* trace = std::getenv(kTraceVariable)) options.trace = trace;
  board_process_ = std::make_unique<device::SimulatedBoardProcess>(options);
  return board_process_->take_transport();
}

}  // namespace hedgehog::daemon
