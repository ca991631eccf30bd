// SPDX-License-Identifier: MIT
// One thread a sensor: opens it when it is there, reads it, and searches for it with exponential
// back-off when it is gone.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "daemon/device/sensors/sensor.h"

namespace hedgehog::device {

/// For `device.list`.
struct SensorState {
  bool open = false;
  /// What is open, or why nothing is.
  std::string what;
  /// Times that it was opened so far.
  unsigned opened = 0;
};

/// Construct and destroy from one thread; `state` from any.
class SensorThread {
 public:
  static constexpr std::chrono::milliseconds kFirstPause{250};
  static constexpr std::chrono::milliseconds kLongestPause{1000};
  /// How long one wait for data lasts, so how soon it notices that it should end.
  static constexpr std::chrono::milliseconds kWait{50};

  /// Starts at once. What the sensor writes to must outlive this. Throws std::system_error.
  explicit SensorThread(std::unique_ptr<Sensor> sensor);
  SensorThread(const SensorThread&) = delete;
  SensorThread& operator=(const SensorThread&) = delete;
  ~SensorThread();

  SensorState state() const;

 private:
  void run();
  void note(bool open, const std::string& what);
  /// False: it is time to end.
  bool pause(std::chrono::milliseconds time);

  std::unique_ptr<Sensor> sensor_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<bool> stop_{false};
  SensorState state_;
  std::thread thread_;
};

}  // namespace hedgehog::device
