// SPDX-License-Identifier: MIT
// Orientation sensors as USB devices: an Xsens MTi, a HID sensor, a DualSense pad. The command
// `turn W X Y Z` sets their orientation in the world.
#pragma once

#include <array>

#include "daemon/device/imu/mtdata2.h"
#include "daemon/device/imu/xbus.h"
#include "emulator/gadget.h"
#include "model/quaternion.h"

namespace hedgehog::emulator {

/// Command `turn`; status {"quaternion", "running", "reports", "lost"}.
class ImuGadget : public Gadget {
 public:
  using Gadget::Gadget;
  std::optional<std::string> command(std::span<const std::string> words) override;
  std::string status() const override;
  void step() override;

 protected:
  /// Sensor -> world, REP-103.
  const model::Quaternion& turned() const noexcept { return turned_; }
  /// True while measuring.
  virtual bool running() const = 0;
  /// Milliseconds between two reports.
  virtual int period_ms() const = 0;
  virtual void report() = 0;

 private:
  model::Quaternion turned_;
  int until_report_ = 0;
  std::uint64_t reports_ = 0;
};

/// MTi-30 on its own USB connector: quaternion, rate, time and status at the configured rate;
/// silent until switched to measurement.
class MtiGadget : public ImuGadget {
 public:
  explicit MtiGadget(const std::string& serial);

 protected:
  bool running() const override { return measuring_; }
  int period_ms() const override { return period_ms_; }
  void report() override;
  void handle_out(std::uint8_t endpoint, std::span<const Byte> data) override;

 private:
  void answer(const device::XbusMessage& message);
  void print(device::XbusId id, std::span<const Byte> payload = {});

  device::XbusParser parser_;
  std::vector<device::MtOutput> outputs_;
  bool measuring_ = false;
  int period_ms_ = 10;
  std::uint16_t counter_ = 0;
  std::uint32_t time_ = 0;
};

/// Device Orientation of the HID sensor page (HUTRR39), four signed 16-bit numbers of 1e-4; silent
/// until its feature report switches it on.
class HidSensorGadget : public ImuGadget {
 public:
  explicit HidSensorGadget(const std::string& serial);

 protected:
  bool running() const override { return feature_[kReporting] == kAllEvents; }
  int period_ms() const override;
  void report() override;
  std::optional<Bytes> handle_control(const SetupPacket& setup,
                                      std::span<const Byte> data) override;
  void handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> /*data*/) override {}

 private:
  // Report id, reporting state, power state, interval in ms (u32).
  static constexpr std::size_t kReporting = 1;
  static constexpr Byte kAllEvents = 2;
  std::array<Byte, 7> feature_{1, 1, 1, 100, 0, 0, 0};
};

/// A DualSense at rest in the set orientation: its accelerometer measures gravity, its gyroscope 0;
/// the calibration report contains a factory bias. Always 250 reports a second.
class PadGadget : public ImuGadget {
 public:
  explicit PadGadget(const std::string& serial);

 protected:
  bool running() const override { return true; }
  int period_ms() const override { return 4; }
  void report() override;
  std::optional<Bytes> handle_control(const SetupPacket& setup,
                                      std::span<const Byte> data) override;
  void handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> /*data*/) override {}

 private:
  std::uint32_t clock_ = 0;  // thirds of a microsecond
};

}  // namespace hedgehog::emulator
