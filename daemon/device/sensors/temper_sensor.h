// SPDX-License-Identifier: MIT
// A TEMPer stick with a port. Of a stick with a probe on a lead only that probe is read: the stick
// itself is outside of the ball, so its own temperature must never replace the probe's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "daemon/device/sensors/port.h"
#include "daemon/device/sensors/sensor.h"
#include "daemon/device/thermometer/temper.h"

namespace hedgehog::device {

class TemperSensor : public Sensor {
 public:
  TemperSensor(OpenHid open, ThermometerSink sink)
      : open_(std::move(open)), sink_(std::move(sink)) {}
  std::string open() override;
  bool poll(std::chrono::milliseconds wait) override;
  void close() override { port_.reset(); }
  const std::string& name() const override { return name_; }

  /// Interval of requests; a response takes about 0.3 s.
  static constexpr model::Tick kEvery = 500;
  /// Maximum time between the reports of one response.
  static constexpr std::chrono::milliseconds kBetween{150};
  static constexpr int kFirmwareTries = 10;

 private:
  /// All reports of the response; nullopt if the stick is disconnected.
  std::optional<std::vector<Byte>> ask(HidPort& port, const TemperReport& question) const;

  OpenHid open_;
  ThermometerSink sink_;
  std::unique_ptr<HidPort> port_;
  std::string name_;
  TemperModel model_;
  std::optional<model::Tick> requested_;
};

}  // namespace hedgehog::device
