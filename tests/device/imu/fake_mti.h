// SPDX-License-Identifier: MIT
// A simulated MTi that follows the protocol, and can refuse rates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/device/imu/mtdata2.h"
#include "daemon/device/imu/xbus.h"

namespace hedgehog::device {

struct FakeMti {
  bool measuring = false;
  std::uint16_t highest_rate = 1000;
  std::vector<MtOutput> outputs;
  XbusParser parser;

  std::vector<Byte> respond(const std::vector<Byte>& sent) {
    std::vector<Byte> bytes;
    parser.feed(sent);
    while (const auto next = parser.next()) {
      const XbusMessage& message = *next;
      const auto send = [&](XbusId id, std::span<const Byte> payload = {}) {
        const auto more = encode_xbus(id, payload);
        bytes.insert(bytes.end(), more.begin(), more.end());
      };
      if (message.id == XbusId::kGotoConfig) {
        measuring = false;
        send(XbusId::kGotoConfigAck);
      } else if (message.id == XbusId::kSetOutputConfiguration) {
        const auto requested = decode_outputs(message.payload).value();
        const bool too_fast = std::any_of(
            requested.begin(), requested.end(),
            [&](const MtOutput& o) { return o.rate_hz != 0xFFFF && o.rate_hz > highest_rate; });
        if (too_fast) {
          send(XbusId::kError, std::vector<Byte>{0x04});
        } else {
          outputs = requested;
          send(XbusId::kOutputConfiguration, message.payload);
        }
      } else if (message.id == XbusId::kGotoMeasurement) {
        measuring = true;
        send(XbusId::kGotoMeasurementAck);
      }
    }
    return bytes;
  }
};

}  // namespace hedgehog::device
