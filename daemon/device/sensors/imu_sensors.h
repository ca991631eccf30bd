// SPDX-License-Identifier: MIT
// Orientation sensors: a codec of imu/ with a port.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "daemon/device/imu/fusion.h"
#include "daemon/device/imu/hid_orientation.h"
#include "daemon/device/imu/mti_session.h"
#include "daemon/device/imu/sony_pad.h"
#include "daemon/device/sensors/port.h"
#include "daemon/device/sensors/sensor.h"

namespace hedgehog::device {

/// A HID sensor with its own quaternion. Without a reported rate, the rate is derived from the
/// rotation.
class HidSensorImu : public Sensor {
 public:
  HidSensorImu(OpenHid open, OrientationSink sink)
      : open_(std::move(open)), sink_(std::move(sink)) {}
  std::string open() override;
  bool poll(std::chrono::milliseconds wait) override;
  void close() override { port_.reset(); }
  const std::string& name() const override { return name_; }

  static constexpr double kIntervalS = 0.01;

 private:
  void publish(const HidOrientationSample& sample);

  OpenHid open_;
  OrientationSink sink_;
  std::unique_ptr<HidPort> port_;
  std::string name_;
  std::optional<HidOrientation> codec_;
  std::optional<model::Quaternion> last_;
  model::Tick last_tick_ = 0;
};

/// A Sony pad, with sensor fusion in this class.
class SonyImu : public Sensor {
 public:
  SonyImu(SonyPad pad, OpenHid open, OrientationSink sink)
      : pad_(pad), open_(std::move(open)), sink_(std::move(sink)) {}
  std::string open() override;
  bool poll(std::chrono::milliseconds wait) override;
  void close() override { port_.reset(); }
  const std::string& name() const override { return name_; }
  const Fusion& fusion() const noexcept { return fusion_; }

 private:
  SonyPad pad_;
  OpenHid open_;
  OrientationSink sink_;
  std::unique_ptr<HidPort> port_;
  std::string name_;
  SonyCalibration calibration_;
  Fusion fusion_;
  std::optional<double> clock_us_;
  model::Tick last_tick_ = 0;
};

/// An Xsens MTi with its own quaternion.
class MtiImu : public Sensor {
 public:
  MtiImu(OpenBytes open, OrientationSink sink) : open_(std::move(open)), sink_(std::move(sink)) {}
  std::string open() override;
  bool poll(std::chrono::milliseconds wait) override;
  void close() override { port_.reset(); }
  const std::string& name() const override { return name_; }

 private:
  double now_s() const { return static_cast<double>(sink_.tick()) * model::kTickSeconds; }

  OpenBytes open_;
  OrientationSink sink_;
  std::unique_ptr<BytePort> port_;
  std::string name_;
  MtiSession session_;
};

}  // namespace hedgehog::device
