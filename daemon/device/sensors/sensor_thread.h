// SPDX-License-Identifier: MIT
// One thread per sensor: opens it when it is connected, reads it, and searches for it with
// exponential back-off when it is not.
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
  std::string what;     // name of the opened device, or the reason for which none is open
  unsigned opened = 0;  // number of times
};

/// Construct and destroy from one thread; `state` from any.
class SensorThread {
 public:
  static constexpr std::chrono::milliseconds kFirstPause{250};
  static constexpr std::chrono::milliseconds kLongestPause{1000};
  /// Duration of one wait for data, and therefore the latency of the shutdown.
  static constexpr std::chrono::milliseconds kWait{50};

  /// Starts at once. The sensor's sinks must outlive this. Throws std::system_error.
  explicit SensorThread(std::unique_ptr<Sensor> sensor);
  SensorThread(const SensorThread&) = delete;
  SensorThread& operator=(const SensorThread&) = delete;
  ~SensorThread();

  SensorState state() const;

 private:
  void run();
  void note(bool open, const std::string& what);
  bool pause(std::chrono::milliseconds time);  // false: the thread has to end

  std::unique_ptr<Sensor> sensor_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<bool> stop_{false};
  SensorState state_;
  std::thread thread_;
};

}  // namespace hedgehog::device
