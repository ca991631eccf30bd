// SPDX-License-Identifier: MIT
// Interface of a sensor for its thread.
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

  /// Finds, opens and switches it on. Empty on success; else a sentence with the reason.
  virtual std::string open() = 0;
  /// Processes the data received within `wait`. False: disconnected; `close` and `open` again.
  virtual bool poll(std::chrono::milliseconds wait) = 0;
  virtual void close() = 0;
  /// Name of the opened device for display.
  virtual const std::string& name() const = 0;
};

/// Device time for time stamps: the present tick.
using TickSource = std::function<model::Tick()>;

/// Destination of an orientation sensor's samples.
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
