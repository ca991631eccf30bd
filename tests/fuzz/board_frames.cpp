// SPDX-License-Identifier: MIT
// Arbitrary packets to the board and to the host's end of the link, with and without a valid check
// sum. For any packets, a board that is not driving keeps its bridges asleep.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "daemon/device/board_core/board_core.h"
#include "daemon/device/board_core/crc32.h"
#include "daemon/device/link.h"

namespace {

namespace board = hedgehog::board;

constexpr std::size_t kCrcAt = board::kFrameSize - 4;

/// The packet that `spec` defines: a length, and whether its header and check sum are made valid.
std::span<const std::uint8_t> packet(std::span<const std::uint8_t> spec,
                                     std::array<std::uint8_t, 2 * board::kFrameSize>& buffer) {
  const std::uint8_t kind = spec[0];
  const auto body = spec.subspan(1);
  buffer.fill(0);
  std::copy(body.begin(), body.end(), buffer.begin());
  if (kind % 4 == 0) return {buffer.data(), body.size()};
  buffer[0] = board::kFrameMagic;
  buffer[1] = board::kProtocolVersion;
  const std::uint32_t sum = board::crc32(buffer.data(), kCrcAt);
  for (std::size_t i = 0; i < 4; ++i)
    buffer[kCrcAt + i] = static_cast<std::uint8_t>(sum >> (8 * i));
  return {buffer.data(), board::kFrameSize};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  board::BoardCore core{board::BoardLimits{}};
  board::BoardInputs inputs;
  inputs.supply_mv = 12000;
  inputs.thermistor[0].cc = 2500;
  inputs.thermistors_converted = true;
  hedgehog::device::Link link;
  std::array<std::uint8_t, 2 * board::kFrameSize> buffer;
  std::span<const std::uint8_t> rest(data, size);
  while (!rest.empty()) {
    const std::size_t length = std::min<std::size_t>(rest.size(), board::kFrameSize + 1);
    const auto bytes = packet(rest.first(length), buffer);
    rest = rest.subspan(length);
    core.receive(bytes.data(), bytes.size());
    link.receive(bytes);
    const board::BoardOutputs outputs = core.step(inputs);
    const bool drives = core.mode() == board::Mode::kDriving;
    for (const std::int16_t duty : outputs.duty_q15)
      if (!drives && (outputs.awake || duty != 0)) std::abort();
    (void)link.step({});
  }
  return 0;
}
