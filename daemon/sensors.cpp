// SPDX-License-Identifier: MIT
#include "daemon/sensors.h"

#include <utility>

#include "daemon/device/sensors/usb_ports.h"

namespace hedgehog::daemon {
namespace {

constexpr std::chrono::milliseconds kLookEvery{500};

}  // namespace

Sensors::Sensors(const config::Config& config, control::Mailbox& mailbox, const control::Loop& loop,
                 const device::UsbBoard* board)
    : board_(board) {
  if (board_ != nullptr) readers_.push_back({{"board", "usb", {}}, nullptr});
  const device::TickSource tick = [&loop] { return loop.now(); };
  const auto& fitting = config.imu_fitting;
  const device::SensorSinks sinks{
      {tick, device::Mounting::of(fitting.front, fitting.up).value_or(device::Mounting()),
       [&mailbox](const device::OrientationSample& sample) { mailbox.orientation.write(sample); }},
      {tick,
       [&mailbox](const device::ThermometerSample& sample) { mailbox.thermometer.write(sample); }}};
  add("imu", config.imu.driver, fitting.serial, sinks);
  add("thermometer", config.thermometer.driver, config.thermometer.serial, sinks);
}

void Sensors::add(const std::string& job, const device::SensorDriver* driver,
                  const std::string& serial, const device::SensorSinks& sinks) {
  if (driver == nullptr) return;
  readers_.push_back(
      {{job, std::string(driver->type), {}},
       std::make_unique<device::SensorThread>(device::make_sensor(*driver, serial, sinks))});
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

server::BoardInfo Sensors::board_info() const {
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
    const device::SensorState current = state(reader);
    const device::SensorState& before = reader.line.state;
    if (current.what == before.what && current.opened == before.opened) continue;
    sentences.push_back(reader.line.job + ": " + current.what);
    reader.line.state = current;
  }
  return sentences;
}

}  // namespace hedgehog::daemon
