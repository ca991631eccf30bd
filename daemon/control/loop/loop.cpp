// SPDX-License-Identifier: MIT
#include "daemon/control/loop/loop.h"

#include <pthread.h>

#include "daemon/device/tick_clock.h"

namespace hedgehog::control {

Loop::Loop(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
           FlightRecorder* recorder, int speed)
    : tick_(settings, mailbox, port, recorder, speed),
      origin_ns_(device::at_phase_before(device::monotonic_ns(), device::kControlPhaseNs)) {}

void Loop::start() {
  const device::SignalsBlocked blocked;
  thread_ = std::thread([this] {
    pthread_setname_np(pthread_self(), "control");
    realtime_ = schedule();
    started_.store(true, std::memory_order_release);
    started_.notify_one();
    run();
    shut_down();
  });
  started_.wait(false, std::memory_order_acquire);
}

bool Loop::stop() noexcept {
  stopping_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
  return confirmed_;
}

void Loop::shut_down() noexcept {
  tick_.shut_down();
  for (int i = 0; i < ControlTick::kMaxSafeTicks && !confirmed_; ++i) {
    confirmed_ = tick_.run_safe();
    after_safe_tick();
  }
}

}  // namespace hedgehog::control
