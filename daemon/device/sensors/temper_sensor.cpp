// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/temper_sensor.h"

#include <algorithm>
#include <array>
#include <utility>

#include "daemon/device/sensors/drivers.h"

namespace hedgehog::device {
namespace {

constexpr std::size_t kMaxReports = 4;
constexpr std::array<UsbIds, 4> kIds{
    {{0x0C45, 0x7401}, {0x0C45, 0x7402}, {0x413D, 0x2107}, {0x1A86, 0xE025}}};
/// A stick is a keyboard on its first interface and a thermometer on its second.
constexpr int kThermometerInterface = 1;

}  // namespace

std::optional<std::vector<Byte>> TemperSensor::ask(HidPort& port,
                                                   const TemperReport& question) const {
  std::array<Byte, 1 + kTemperReport> out{};  // no report ids: 0 in front
  std::copy(question.begin(), question.end(), out.begin() + 1);
  if (!port.write(out)) return std::nullopt;
  std::vector<Byte> answer;
  for (std::size_t i = 0; i < kMaxReports; ++i) {
    TemperReport report{};
    // The first report takes longer.
    const auto length = port.read(report, i == 0 ? 3 * kBetween : kBetween);
    if (!length) return std::nullopt;
    if (*length == 0) break;
    answer.insert(answer.end(), report.begin(), report.end());
  }
  return answer;
}

std::string TemperSensor::open() {
  OpenedHid opened = open_();
  if (!opened.port) return opened.failure;
  std::string firmware;
  for (int i = 0; i < kFirmwareTries; ++i) {
    const auto answer = ask(*opened.port, kTemperAskFirmware);
    if (!answer) return opened.name + ": it was disconnected";
    firmware = temper_firmware(*answer);
    if (const auto model = temper_model(firmware)) {
      model_ = *model;
      name_ = opened.name + ", " + firmware;
      port_ = std::move(opened.port);
      requested_.reset();
      return {};
    }
  }
  return opened.name + (firmware.empty() ? ": it does not report its firmware"
                                         : ": its firmware \"" + firmware + "\" is not supported");
}

bool TemperSensor::poll(std::chrono::milliseconds wait) {
  if (requested_ && sink_.tick() - *requested_ < kEvery) {
    // The stick sends nothing unrequested; reading waits, and detects unplugging.
    TemperReport report{};
    return port_->read(report, wait).has_value();
  }
  requested_ = sink_.tick();
  const auto answer = ask(*port_, kTemperAskTemperature);
  if (!answer) return false;
  const auto reading = decode_temper(model_, *answer);
  if (!reading) return true;
  const auto& celsius = model_.external_at != 0 ? reading->external_c : reading->internal_c;
  if (celsius) sink_.write({true, *celsius, sink_.tick()});
  return true;
}

constinit const SensorDriver kTemperDriver{
    .type = "temper",
    .words = "TEMPer thermometer",
    .job = SensorJob::kThermometer,
    .matches_hid =
        [](const HidDevice& device) {
          return has_ids(device, kIds) &&
                 (!device.usb || device.usb->interface == kThermometerInterface);
        },
    .make_hid = [](OpenHid open, const SensorSinks& sinks) -> std::unique_ptr<Sensor> {
      return std::make_unique<TemperSensor>(std::move(open), sinks.thermometer);
    }};

}  // namespace hedgehog::device
