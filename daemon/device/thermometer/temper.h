// SPDX-License-Identifier: MIT
// TEMPer thermometers: USB sticks with 8-byte HID reports. Source: the open tool "temper" (urwen,
// MIT); reference: hardware.md section 6. Pure; any thread.
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

/// Requests the firmware's name, as ASCII in several reports.
inline constexpr TemperReport kTemperAskFirmware{0x01, 0x86, 0xFF, 0x01, 0, 0, 0, 0};
/// Requests the temperatures, in one or two reports.
inline constexpr TemperReport kTemperAskTemperature{0x01, 0x80, 0x33, 0x01, 0, 0, 0, 0};

/// Layout of the numbers of a firmware.
struct TemperModel {
  std::string firmware;
  double divisor = 100.0;
  std::size_t external_at = 0;  // byte of the probe on a lead, over all reports; 0: no probe
};

std::string temper_firmware(std::span<const Byte> answer);  // the leading printable characters
std::optional<TemperModel> temper_model(std::string_view firmware);  // nullopt: unknown layout

struct TemperReading {
  std::optional<double> internal_c;  // missing: no sensor, or outside -40..125 C
  std::optional<double> external_c;
};

/// `answer`: all reports, concatenated. nullopt if it is not a response to the request.
std::optional<TemperReading> decode_temper(const TemperModel& model, std::span<const Byte> answer);

}  // namespace hedgehog::device
