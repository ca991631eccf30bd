// SPDX-License-Identifier: MIT
#include "emulator/firmware/board_link.h"

#include <algorithm>
#include <stdexcept>

#include "daemon/device/board_core/crc32.h"

namespace hedgehog::emulator {
namespace {

constexpr Byte kStart = 'H';
constexpr Byte kResponse = 0x80;
constexpr Byte kError = 0xFF;
constexpr std::size_t kHead = 4;
constexpr std::size_t kCrc = 4;
constexpr std::size_t kMaxPayload = 4096;
/// Of the port, without a byte: half a minute or more of the host, where a millisecond of the board
/// takes a few.
constexpr int kMaxPolls = 4'000'000;

void put_little(Bytes& to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to.push_back(static_cast<Byte>(value >> 8 * i));
}

[[noreturn]] void reject(const std::string& what) {
  throw std::runtime_error("the process of the emulated board " + what);
}

/// Reads a payload from its start.
class Reader {
 public:
  explicit Reader(std::span<const Byte> bytes) : bytes_(bytes) {}
  std::span<const Byte> next(std::size_t length) {
    if (length > bytes_.size()) reject("has sent a response that is too short");
    const auto part = bytes_.first(length);
    bytes_ = bytes_.subspan(length);
    return part;
  }
  std::size_t number() { return next(1)[0]; }
  std::span<const Byte> rest() { return next(bytes_.size()); }

 private:
  std::span<const Byte> bytes_;
};

}  // namespace

Bytes BoardLink::receive(std::size_t length) {
  Bytes bytes;
  bytes.reserve(length);
  for (int polls = 0; bytes.size() < length;) {
    if (const auto byte = port_->poll()) {
      bytes.push_back(*byte);
      polls = 0;
    } else if (++polls == kMaxPolls) {
      reject("does not respond");
    }
  }
  return bytes;
}

Bytes BoardLink::request(Type type, std::span<const Byte> payload) {
  Bytes message{kStart, static_cast<Byte>(type)};
  put_little(message, static_cast<std::uint32_t>(payload.size()), 2);
  message.insert(message.end(), payload.begin(), payload.end());
  put_little(message, board::crc32(message.data(), message.size()), kCrc);
  port_->write(message);

  Bytes response = receive(kHead);
  const std::size_t length = device::little_u16(&response[2]);
  if (response[0] != kStart || length > kMaxPayload) reject("has sent something else");
  const Bytes rest = receive(length + kCrc);
  response.insert(response.end(), rest.begin(), rest.end());
  if (device::little_u32(&response[kHead + length]) !=
      board::crc32(response.data(), kHead + length))
    reject("has sent a wrong check sum");
  const auto begin = response.begin() + kHead;
  Bytes content(begin, begin + static_cast<std::ptrdiff_t>(length));
  if (response[1] == kError) reject("reports: " + std::string(content.begin(), content.end()));
  if (response[1] != (static_cast<Byte>(type) | kResponse)) reject("has answered another request");
  return content;
}

std::optional<Bytes> BoardLink::control(const SetupPacket& setup, std::span<const Byte> data) {
  Bytes payload{setup.type, setup.request};
  for (const std::uint16_t word : {setup.value, setup.index, setup.length})
    put_little(payload, word, 2);
  payload.insert(payload.end(), data.begin(), data.end());
  const Bytes response = request(Type::kControl, payload);
  Reader reader(response);
  if (reader.number() != 0) return std::nullopt;
  const auto rest = reader.rest();
  return Bytes(rest.begin(), rest.end());
}

BoardLink::Millisecond BoardLink::run(std::span<const Bytes> out, std::size_t reads) {
  Bytes payload{static_cast<Byte>(std::min(reads, kMaxPackets)), static_cast<Byte>(out.size())};
  for (const Bytes& packet : out) {
    payload.push_back(static_cast<Byte>(packet.size()));
    payload.insert(payload.end(), packet.begin(), packet.end());
  }
  const Bytes response = request(Type::kRun, payload);
  Reader reader(response);
  Millisecond made;
  const std::size_t flags = reader.number();
  made.in_halted = (flags & 1) != 0;
  made.out_halted = (flags & 2) != 0;
  made.queued = reader.number();
  for (std::size_t left = reader.number(); left > 0; --left) {
    const auto packet = reader.next(reader.number());
    made.in.emplace_back(packet.begin(), packet.end());
  }
  const auto events = reader.rest();
  made.events.assign(events.begin(), events.end());
  return made;
}

std::string BoardLink::status() {
  const Bytes text = request(Type::kStatus, {});
  return {text.begin(), text.end()};
}

}  // namespace hedgehog::emulator
