// SPDX-License-Identifier: MIT
// Encodes messages as bytes on a connection, and decodes them: lines, or WebSocket frames after
// their handshake.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::soak {

enum class Transport : std::uint8_t { kTcp, kUnix, kWebSocket, kHttp };
std::string_view name(Transport transport) noexcept;

inline constexpr int kTextFrame = 1;
inline constexpr int kBinaryFrame = 2;
inline constexpr int kCloseFrame = 8;
inline constexpr int kPingFrame = 9;
inline constexpr int kPongFrame = 10;

/// A frame sent by a client. `last`: the final frame of its message; 0 as `opcode`: a continuation.
std::string web_frame(int opcode, std::string_view payload, bool last = true);
/// The request to upgrade to WebSocket.
std::string web_handshake(int port);

struct Received {
  int opcode = kTextFrame;
  std::string payload;
};

/// Extracts messages from received bytes.
class Unframer {
 public:
  explicit Unframer(Transport transport) : transport_(transport) {}

  void feed(std::string_view bytes) { bytes_ += bytes; }
  /// The next complete message; nullopt: none yet. Throws Failure on frames that a server must not
  /// send.
  std::optional<Received> next();
  /// The status of the handshake's response; 0 before it, and on transports without a handshake.
  int status() const noexcept { return status_; }

 private:
  std::optional<Received> next_line();
  std::optional<Received> next_frame();
  bool read_handshake();

  Transport transport_;
  std::string bytes_;
  std::size_t consumed_ = 0;  // of bytes_
  int status_ = 0;
};

}  // namespace hedgehog::soak
