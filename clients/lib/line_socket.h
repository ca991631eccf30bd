// SPDX-License-Identifier: MIT
// A connected socket for lines of text; each operation has a deadline.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "clients/lib/address.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

/// One thread at a time. Movable. The destructor closes it.
class LineSocket {
 public:
  /// Longest line accepted from the daemon; a longer one ends the connection.
  static constexpr std::size_t kMaxIncomingLine = std::size_t{4} << 20;

  /// With TCP_NODELAY. kNoDaemon: no connection by `deadline`; the message is the reason alone
  /// ("connection refused").
  static Outcome<LineSocket> connect(const Address& address, Clock::time_point deadline);
  /// Begins to connect and does not block, except for the look-up of a host name (not of a numeric
  /// address).
  static Outcome<LineSocket> start_connect(const Address& address);
  /// After `start_connect`: whether it is connected, by `deadline` at the latest (one in the past
  /// does not block). kNoDaemon as above.
  Outcome<bool> connected(Clock::time_point deadline);

  ~LineSocket();
  LineSocket(LineSocket&&) noexcept;
  LineSocket& operator=(LineSocket&&) noexcept;

  /// Sends `line` and LF. A line that could not be sent completely in time ends the connection.
  Outcome<void> write(std::string_view line, Clock::time_point deadline);
  /// The next line without its LF or CRLF; nullopt if it was incomplete at `deadline` (nothing is
  /// lost). A deadline in the past still reads what has been received.
  Outcome<std::optional<std::string>> read(Clock::time_point deadline);
  /// For poll(2); -1 once it is closed.
  int descriptor() const noexcept;

 private:
  struct Impl;
  explicit LineSocket(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::client
