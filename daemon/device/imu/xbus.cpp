// SPDX-License-Identifier: MIT
#include "daemon/device/imu/xbus.h"

#include <algorithm>
#include <numeric>

namespace hedgehog::device {
namespace {

constexpr Byte kPreamble = 0xFA;
constexpr Byte kMaster = 0xFF;
constexpr Byte kExtended = 0xFF;
constexpr std::size_t kShortHead = 4;
constexpr std::size_t kExtendedHead = 6;

/// Modulo 256 by the type.
Byte sum(std::span<const Byte> bytes) noexcept {
  return std::accumulate(
      bytes.begin(), bytes.end(), Byte{0}, [](Byte a, Byte b) { return static_cast<Byte>(a + b); });
}

struct Candidate {
  enum class Is : std::uint8_t { kIncomplete, kNoise, kMessage };
  Is is = Is::kIncomplete;
  std::size_t head = 0;
  std::size_t payload = 0;
};

/// Classifies the bytes from `bytes[0]`, a preamble.
Candidate examine(std::span<const Byte> bytes) noexcept {
  using Is = Candidate::Is;
  if (bytes.size() >= 2 && bytes[1] != kMaster) return {Is::kNoise};
  if (bytes.size() < kShortHead) return {};
  Candidate found{Is::kIncomplete, kShortHead, bytes[3]};
  if (bytes[3] == kExtended) {
    if (bytes.size() < kExtendedHead) return {};
    found.head = kExtendedHead;
    found.payload = big_u16(&bytes[4]);
    if (found.payload > kXbusMaxPayload) return {Is::kNoise};
  }
  const std::size_t length = found.head + found.payload + 1;
  if (bytes.size() < length) return found;
  found.is = sum(bytes.subspan(1, length - 1)) == 0 ? Is::kMessage : Is::kNoise;
  return found;
}

}  // namespace

std::vector<Byte> encode_xbus(XbusId id, std::span<const Byte> payload) {
  std::vector<Byte> bytes{kPreamble, kMaster, static_cast<Byte>(id)};
  if (payload.size() < kExtended) {
    bytes.push_back(static_cast<Byte>(payload.size()));
  } else {
    bytes.push_back(kExtended);
    bytes.push_back(static_cast<Byte>(payload.size() >> 8));
    bytes.push_back(static_cast<Byte>(payload.size()));
  }
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  bytes.push_back(static_cast<Byte>(-sum(std::span<const Byte>(bytes).subspan(1))));
  return bytes;
}

void XbusParser::feed(std::span<const Byte> bytes) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
}

std::optional<XbusMessage> XbusParser::next() {
  std::size_t at = 0;
  std::optional<XbusMessage> message;
  while (at < waiting_.size()) {
    const auto from = waiting_.begin() + static_cast<std::ptrdiff_t>(at);
    const auto preamble = std::find(from, waiting_.end(), kPreamble);
    skipped_ += static_cast<std::size_t>(preamble - from);
    at = static_cast<std::size_t>(preamble - waiting_.begin());
    const auto rest = std::span<const Byte>(waiting_).subspan(at);
    const Candidate found = rest.empty() ? Candidate{} : examine(rest);
    if (found.is == Candidate::Is::kIncomplete) break;
    if (found.is == Candidate::Is::kMessage) {
      const auto payload = rest.subspan(found.head, found.payload);
      message = XbusMessage{static_cast<XbusId>(rest[2]), {payload.begin(), payload.end()}};
      at += found.head + found.payload + 1;
      break;
    }
    ++at;
    ++skipped_;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  return message;
}

}  // namespace hedgehog::device
