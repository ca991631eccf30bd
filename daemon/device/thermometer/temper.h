// SPDX-License-Identifier: MIT
// Thermometers of the TEMPer kind: USB sticks that speak in 8-byte HID reports. Source: the queries
// and layouts published with the open tool "temper" (urwen, MIT); reference: hardware.md section 6.
// Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

inline constexpr std::size_t kTemperReport = 8;
using TemperReport = std::array<Byte, kTemperReport>;

/// The firmware's name, as ASCII in several reports.
inline constexpr TemperReport kTemperAskFirmware{0x01, 0x86, 0xFF, 0x01, 0, 0, 0, 0};
/// The temperatures, in one or two reports.
inline constexpr TemperReport kTemperAskTemperature{0x01, 0x80, 0x33, 0x01, 0, 0, 0, 0};

/// How a firmware lays its numbers out.
struct TemperModel {
  std::string firmware;
  double divisor = 100.0;
  /// Byte of the probe on a lead, counted over all reports of an answer; 0: it has none.
  std::size_t external_at = 0;
};

/// The printable characters at the front of the answer.
std::string temper_firmware(std::span<const Byte> answer);
/// Nothing for a firmware whose layout is not known: its numbers would be guesses.
std::optional<TemperModel> temper_model(std::string_view firmware);

struct TemperReading {
  /// Missing: no sensor there, or a number outside -40..125 C.
  std::optional<double> internal_c;
  std::optional<double> external_c;
};

/// `answer`: all reports, one behind the other. Nothing when it is no answer to the question.
std::optional<TemperReading> decode_temper(const TemperModel& model, std::span<const Byte> answer);

}  // namespace hedgehog::device
