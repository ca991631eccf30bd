// SPDX-License-Identifier: MIT
// A TEMPer stick behind a port. A stick that has a probe on a lead is read by that probe alone: the
// stick itself hangs outside of the ball, so its own temperature must never stand in for it.
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

  /// Asked this often; an answer takes about 0.3 s.
  static constexpr model::Tick kEvery = 500;
  /// The reports of one answer come within this of each other.
  static constexpr std::chrono::milliseconds kBetween{150};
  static constexpr int kFirmwareTries = 10;

 private:
  /// All reports of the answer; nothing when the stick is gone.
  std::optional<std::vector<Byte>> ask(HidPort& port, const TemperReport& question) const;

  OpenHid open_;
  ThermometerSink sink_;
  std::unique_ptr<HidPort> port_;
  std::string name_;
  TemperModel model_;
  std::optional<model::Tick> asked_;
};

}  // namespace hedgehog::device
