// SPDX-License-Identifier: MIT
#include "daemon/sensors.h"

#include <utility>

#include "daemon/device/sensors/imu_sensors.h"
#include "daemon/device/sensors/temper_sensor.h"
#include "daemon/device/sensors/usb_ports.h"

namespace hedgehog::daemon {
namespace {

using config::ImuType;
using device::SensorKind;

constexpr std::chrono::milliseconds kLookEvery{500};

std::unique_ptr<device::Sensor> make_imu(const config::Config& config,
                                         device::OrientationSink sink) {
  const auto hid = [&config](SensorKind kind) -> device::OpenHid {
    return [kind, serial = config.imu_fitting.serial] { return device::open_hid(kind, serial); };
  };
  switch (config.imu) {
    case ImuType::kHidSensor:
      return std::make_unique<device::HidSensorImu>(hid(SensorKind::kHidSensor), std::move(sink));
    case ImuType::kDualSense:
      return std::make_unique<device::SonyImu>(device::SonyPad::kDualSense,
                                               hid(SensorKind::kDualSense), std::move(sink));
    case ImuType::kDualShock4:
      return std::make_unique<device::SonyImu>(device::SonyPad::kDualShock4,
                                               hid(SensorKind::kDualShock4), std::move(sink));
    case ImuType::kMti:
      return std::make_unique<device::MtiImu>(
          [serial = config.imu_fitting.serial] { return device::open_mti(serial); },
          std::move(sink));
    case ImuType::kNone:
    case ImuType::kSimulator:
    case ImuType::kExternal:
      break;
  }
  return nullptr;
}

}  // namespace

Sensors::Sensors(const config::Config& config, control::Mailbox& mailbox, const control::Loop& loop,
                 const device::UsbBoard* board)
    : board_(board) {
  if (board_ != nullptr) readers_.push_back({{"board", "usb", {}}, nullptr});
  const device::TickSource tick = [&loop] { return loop.now(); };
  const auto& fitting = config.imu_fitting;
  add("imu", std::string(config::name(config.imu)),
      make_imu(config,
               {tick, device::Mounting::of(fitting.front, fitting.up).value_or(device::Mounting()),
                [&mailbox](const device::OrientationSample& sample) {
                  mailbox.orientation.write(sample);
                }}));
  if (config.thermometer.type == config::ThermometerType::kTemper) {
    device::ThermometerSink sink{
        tick,
        [&mailbox](const device::ThermometerSample& sample) { mailbox.thermometer.write(sample); }};
    add("thermometer", "temper",
        std::make_unique<device::TemperSensor>(
            [serial = config.thermometer.serial] {
              return device::open_hid(SensorKind::kTemper, serial);
            },
            std::move(sink)));
  }
}

void Sensors::add(const std::string& job, const std::string& type,
                  std::unique_ptr<device::Sensor> sensor) {
  if (!sensor) return;
  readers_.push_back({{job, type, {}}, std::make_unique<device::SensorThread>(std::move(sensor))});
}

device::SensorState Sensors::state(const Reader& reader) const {
  if (reader.thread) return reader.thread->state();
  const device::BoardUsbInfo usb_info = board_->usb_info();
  return {usb_info.open, usb_info.what, static_cast<unsigned>(usb_info.opened)};
}

std::vector<SensorLine> Sensors::list() const {
  std::vector<SensorLine> lines;
  for (const Reader& reader : readers_)
    lines.push_back({reader.line.job, reader.line.type, state(reader)});
  return lines;
}

std::optional<device::BoardUsbInfo> Sensors::board() const {
  return board_ != nullptr ? std::optional(board_->usb_info()) : std::nullopt;
}

server::BoardInfo Sensors::board_seen() const {
  if (board_ == nullptr) return {};
  device::BoardUsbInfo usb_info = board_->usb_info();
  if (usb_info.open || !usb_info.seen) usb_info.what.clear();
  return {std::move(usb_info.what), std::move(usb_info.serial), std::move(usb_info.firmware)};
}

std::vector<std::string> Sensors::messages() {
  std::vector<std::string> sentences;
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < kLookEvery) return sentences;
  looked_ = now;
  for (Reader& reader : readers_) {
    const device::SensorState now_is = state(reader);
    const device::SensorState& before = reader.line.state;
    if (now_is.what == before.what && now_is.opened == before.opened) continue;
    sentences.push_back(reader.line.job + ": " + now_is.what);
    reader.line.state = now_is;
  }
  return sentences;
}

}  // namespace hedgehog::daemon
