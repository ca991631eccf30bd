// SPDX-License-Identifier: MIT
#include "tests/soak/framing.h"

#include "tests/soak/failure.h"

namespace hedgehog::soak {
namespace {

constexpr std::size_t kTwoDigits = 126;
constexpr std::size_t kEightDigits = 127;

void append_size(std::string& bytes, std::size_t size, int digits) {
  for (int i = digits - 1; i >= 0; --i) bytes += static_cast<char>((size >> (8 * i)) & 0xff);
}

}  // namespace

std::string_view name(Transport transport) noexcept {
  switch (transport) {
    case Transport::kTcp:
      return "TCP";
    case Transport::kUnix:
      return "Unix socket";
    case Transport::kWebSocket:
      return "WebSocket";
    default:
      return "HTTP";
  }
}

std::string web_frame(int opcode, std::string_view payload, bool last) {
  std::string bytes(1, static_cast<char>((last ? 0x80 : 0) | opcode));
  const std::size_t size = payload.size();
  if (size < kTwoDigits) {
    bytes += static_cast<char>(0x80 | size);
  } else if (size < 65536) {
    bytes += static_cast<char>(0x80 | kTwoDigits);
    append_size(bytes, size, 2);
  } else {
    bytes += static_cast<char>(0x80 | kEightDigits);
    append_size(bytes, size, 8);
  }
  constexpr std::string_view kMask = "\x21\x43\x65\x07";
  bytes += kMask;
  for (std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(payload[i] ^ kMask[i % kMask.size()]);
  return bytes;
}

std::string web_handshake(int port) {
  return "GET /ws HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
}

std::optional<Received> Unframer::next() {
  if (transport_ == Transport::kHttp) {
    consumed_ = bytes_.size();
    return std::nullopt;
  }
  if (transport_ == Transport::kWebSocket) {
    if (status_ == 0 && !read_handshake()) return std::nullopt;
    return next_frame();
  }
  return next_line();
}

bool Unframer::read_handshake() {
  const auto end = bytes_.find("\r\n\r\n");
  if (end == std::string::npos) return false;
  constexpr std::string_view kVersion = "HTTP/1.1 ";
  if (!bytes_.starts_with(kVersion)) throw Failure("no HTTP: " + bytes_.substr(0, 80));
  status_ = std::stoi(bytes_.substr(kVersion.size(), 3));
  consumed_ = end + 4;
  return true;
}

std::optional<Received> Unframer::next_line() {
  const auto end = bytes_.find('\n', consumed_);
  if (end == std::string::npos) {
    bytes_.erase(0, consumed_);
    consumed_ = 0;
    return std::nullopt;
  }
  Received line{kTextFrame, bytes_.substr(consumed_, end - consumed_)};
  consumed_ = end + 1;
  return line;
}

std::optional<Received> Unframer::next_frame() {
  const auto left = [&](std::size_t from) { return bytes_.size() - consumed_ >= from; };
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes_[consumed_ + i]));
  };
  if (status_ != 101 || !left(2)) {
    bytes_.erase(0, consumed_);
    consumed_ = 0;
    return std::nullopt;
  }
  // The daemon sends large messages in parts.
  std::string payload;
  int opcode = 0;
  std::size_t at = 0;
  for (bool last = false; !last;) {
    if (!left(at + 2)) return std::nullopt;
    last = (byte(at) & 0x80) != 0;
    const int kind = static_cast<int>(byte(at) & 0x0f);
    if ((byte(at) & 0x70) != 0 || (byte(at + 1) & 0x80) != 0) throw Failure("not a server's frame");
    std::size_t size = byte(at + 1);
    const std::size_t digits = size == kTwoDigits ? 2 : size == kEightDigits ? 8 : 0;
    at += 2;
    if (!left(at + digits)) return std::nullopt;
    if (digits > 0) size = 0;
    for (std::size_t i = 0; i < digits; ++i) size = size << 8 | byte(at + i);
    at += digits;
    if (!left(at + size)) return std::nullopt;
    // A control frame between the parts of a message is delivered before the message.
    if (kind >= kCloseFrame && opcode != 0) {
      Received control{kind, bytes_.substr(consumed_ + at, size)};
      bytes_.erase(consumed_ + at - 2 - digits, 2 + digits + size);
      return control;
    }
    opcode = kind != 0 ? kind : opcode;
    payload.append(bytes_, consumed_ + at, size);
    at += size;
  }
  consumed_ += at;
  return Received{opcode, std::move(payload)};
}

}  // namespace hedgehog::soak
