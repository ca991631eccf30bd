// SPDX-License-Identifier: MIT
// A sensor as its reader thread sees it.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "daemon/device/imu/mounting.h"
#include "daemon/device/orientation.h"
#include "daemon/device/thermometer/sample.h"
#include "model/tick.h"

namespace hedgehog::device {

/// One thread.
class Sensor {
 public:
  Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;
  virtual ~Sensor() = default;

  /// Finds, opens and switches it on. Empty: it runs; else a sentence why not.
  virtual std::string open() = 0;
  /// Handles what came within `wait`. False: it is gone; `close` and `open` again.
  virtual bool poll(std::chrono::milliseconds wait) = 0;
  virtual void close() = 0;
  /// What is open, for people.
  virtual const std::string& name() const = 0;
};

/// Device time, for stamps: the tick of now.
using TickSource = std::function<model::Tick()>;

/// Where an orientation sensor puts what it knows.
struct OrientationSink {
  TickSource tick;
  Mounting mounting;
  std::function<void(const OrientationSample&)> write;

  /// `sensor_to_world` in the sensor's own axes, measured now.
  void publish(const model::Quaternion& sensor_to_world, const model::Vec3& rate_deg_s) const {
    write({true, mounting.ball_to_world(sensor_to_world), mounting.to_ball(rate_deg_s), tick()});
  }
};

struct ThermometerSink {
  TickSource tick;
  std::function<void(const ThermometerSample&)> write;
};

}  // namespace hedgehog::device
