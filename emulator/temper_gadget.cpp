// SPDX-License-Identifier: MIT
#include "emulator/temper_gadget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "daemon/device/thermometer/temper.h"
#include "emulator/words.h"

namespace hedgehog::emulator {
namespace {

constexpr std::uint8_t kHid = 3;
constexpr std::uint8_t kAnswers = 2;  // the thermometer's endpoint
constexpr std::string_view kFirmware = "TEMPerGold_V3.1 ";

Bytes keyboard() {
  return {0x05, 0x01, 0x09, 0x06, 0xA1, 0x01, 0x05, 0x07, 0x19, 0xE0, 0x29, 0xE7, 0x15, 0x00, 0x25,
          0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x95, 0x01, 0x75, 0x08, 0x81, 0x01, 0x95, 0x06,
          0x75, 0x08, 0x15, 0x00, 0x25, 0x65, 0x19, 0x00, 0x29, 0x65, 0x81, 0x00, 0xC0};
}

Bytes thermometer() {
  return {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,
          0x95, 0x08, 0x09, 0x01, 0x81, 0x02, 0x95, 0x08, 0x09, 0x01, 0x91, 0x02, 0xC0};
}

}  // namespace

TemperGadget::TemperGadget(const std::string& serial)
    : Gadget({0x413D,
              0x2107,
              "PCsensor",
              "TEMPerGold",
              serial,
              {{kHid, 1, 1, {{0x81, false, 8}}, keyboard()},
               {kHid, 0, 0, {{0x82, false, 8}}, thermometer()}}}) {}

std::optional<Bytes> TemperGadget::handle_control(const SetupPacket& setup,
                                                  std::span<const Byte> data) {
  if (setup.type != kHidToDevice) return std::nullopt;
  if (setup.request == kHidSetReport && setup.index == 1) handle_out(kAnswers, data);
  return Bytes{};
}

void TemperGadget::handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> data) {
  if (std::equal(data.begin(), data.end(), device::kTemperAskFirmware.begin(),
                 device::kTemperAskFirmware.end())) {
    give(kAnswers, Bytes(kFirmware.begin(), kFirmware.begin() + 8));
    give(kAnswers, Bytes(kFirmware.begin() + 8, kFirmware.end()));
  } else if (std::equal(data.begin(), data.end(), device::kTemperAskTemperature.begin(),
                        device::kTemperAskTemperature.end())) {
    Bytes answer{0x80, 0x80};
    put_u16(answer, static_cast<std::uint16_t>(std::lround(100.0 * celsius_)));
    put_u16(answer, 0x4E20);  // no probe
    answer.resize(8);
    give(kAnswers, std::move(answer));
    ++asked_;
  }
}

std::optional<std::string> TemperGadget::command(std::span<const std::string> words) {
  if (words[0] != "temperature" || words.size() != 2) return std::nullopt;
  const auto value = number<double>(words[1]);
  if (!value || !(*value >= -100.0 && *value <= 300.0)) return "error: temperature -100 to 300";
  celsius_ = *value;
  return "ok";
}

std::string TemperGadget::status() const {
  return fmt::format(R"({{"temperature_c": {:.2f}, "asked": {}}})", celsius_, asked_);
}

}  // namespace hedgehog::emulator
