// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/sensor_thread.h"

#include <algorithm>

#include "daemon/device/tick_clock.h"

namespace hedgehog::device {

SensorThread::SensorThread(std::unique_ptr<Sensor> sensor) : sensor_(std::move(sensor)) {
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { run(); });
}

SensorThread::~SensorThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

SensorState SensorThread::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void SensorThread::note(bool open, const std::string& what) {
  const std::lock_guard lock(mutex_);
  state_.open = open;
  state_.what = what;
  if (open) ++state_.opened;
}

bool SensorThread::pause(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return !wake_.wait_for(lock, time, [this] { return stop_.load(); });
}

void SensorThread::run() {
  auto backoff = kFirstPause;
  do {
    const std::string failure = sensor_->open();
    if (!failure.empty()) {
      note(false, failure);
      backoff = std::min(2 * backoff, kLongestPause);
      continue;
    }
    note(true, sensor_->name());
    const auto since = std::chrono::steady_clock::now();
    while (!stop_ && sensor_->poll(kWait)) {
    }
    note(false, sensor_->name() + ": it was disconnected");
    sensor_->close();
    // Back-off for a device that fails right after opening.
    const bool was_stable = std::chrono::steady_clock::now() - since > kLongestPause;
    backoff = was_stable ? kFirstPause : std::min(2 * backoff, kLongestPause);
  } while (pause(backoff));
}

}  // namespace hedgehog::device
