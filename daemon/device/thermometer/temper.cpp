// SPDX-License-Identifier: MIT
#include "daemon/device/thermometer/temper.h"

#include <algorithm>

namespace hedgehog::device {
namespace {

struct Known {
  std::string_view begins;
  double divisor;
  std::size_t external_at;
};
// The first match is used.
constexpr std::array<Known, 8> kKnown{{{"TEMPerF1.", 256.0, 0},
                                       {"TEMPer1F1.", 256.0, 0},
                                       {"TEMPer2_M12_V1.", 256.0, 4},
                                       {"TEMPerGold_V3.", 100.0, 0},
                                       {"TEMPerX_V3.", 100.0, 10},
                                       {"TEMPer2_V3.", 100.0, 10},
                                       {"TEMPer2_V4.", 100.0, 10},
                                       {"TEMPer1F_V3.", 100.0, 10}}};

constexpr std::size_t kInternalAt = 2;
constexpr std::int16_t kNoSensor = 0x4E20;
constexpr double kLowestC = -40.0;
constexpr double kHighestC = 125.0;

std::optional<double> celsius(std::span<const Byte> answer, std::size_t at, double divisor) {
  if (answer.size() < at + 2) return std::nullopt;
  const std::int16_t raw = big_i16(&answer[at]);
  const double value = raw / divisor;
  if (raw == kNoSensor || value < kLowestC || value > kHighestC) return std::nullopt;
  return value;
}

}  // namespace

std::string temper_firmware(std::span<const Byte> answer) {
  std::string text;
  for (const Byte byte : answer) {
    if (byte <= 0x20 || byte >= 0x7F) break;
    text += static_cast<char>(byte);
  }
  return text;
}

std::optional<TemperModel> temper_model(std::string_view firmware) {
  const auto* known = std::find_if(kKnown.begin(), kKnown.end(),
                                   [&](const Known& k) { return firmware.starts_with(k.begins); });
  if (known == kKnown.end()) return std::nullopt;
  return TemperModel{std::string(firmware), known->divisor, known->external_at};
}

std::optional<TemperReading> decode_temper(const TemperModel& model, std::span<const Byte> answer) {
  // The response repeats the group of the request.
  if (answer.size() < kTemperReport || answer[0] != kTemperAskTemperature[1]) return std::nullopt;
  TemperReading reading;
  reading.internal_c = celsius(answer, kInternalAt, model.divisor);
  if (model.external_at != 0)
    reading.external_c = celsius(answer, model.external_at, model.divisor);
  return reading;
}

}  // namespace hedgehog::device
