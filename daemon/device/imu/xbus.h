// SPDX-License-Identifier: MIT
// Messages of Xsens motion trackers: FA FF MID LEN payload CS, where all bytes after FA add up to 0
// mod 256; LEN = FF is followed by a 16-bit length. Source: "MT Low-Level Communication Protocol
// Documentation", and Xsens' published BSD sources (xspublic). Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

/// Message ids. The response to a request has the next id.
enum class XbusId : std::uint8_t {
  kRequestDeviceId = 0x00,
  kDeviceId = 0x01,
  kGotoMeasurement = 0x10,
  kGotoMeasurementAck = 0x11,
  kGotoConfig = 0x30,
  kGotoConfigAck = 0x31,
  kMtData2 = 0x36,
  kWakeUp = 0x3E,
  kWakeUpAck = 0x3F,
  kReset = 0x40,
  kError = 0x42,
  kSetOutputConfiguration = 0xC0,
  kOutputConfiguration = 0xC1,
};

struct XbusMessage {
  XbusId id = XbusId::kError;  // any number, not only the enumerators
  std::vector<Byte> payload;
  friend bool operator==(const XbusMessage&, const XbusMessage&) = default;
};

/// Longer ones are treated as noise; MTData2 with all outputs is below 400 bytes.
inline constexpr std::size_t kXbusMaxPayload = 2048;

/// REQUIRES: payload.size() <= kXbusMaxPayload.
std::vector<Byte> encode_xbus(XbusId id, std::span<const Byte> payload = {});

/// Finds messages in a stream of bytes and resynchronises after noise: after a corrupt message the
/// search continues at the byte after its FA, because FA may also occur inside a payload.
class XbusParser {
 public:
  void feed(std::span<const Byte> bytes);
  std::optional<XbusMessage> next();                         // nullopt until more bytes are fed
  std::size_t skipped() const noexcept { return skipped_; }  // bytes outside of messages

 private:
  std::vector<Byte> waiting_;
  std::size_t skipped_ = 0;
};

}  // namespace hedgehog::device
