// SPDX-License-Identifier: MIT
// A client with minimal overhead: a blocking TCP socket with lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hedgehog::bench {

inline constexpr std::string_view kPing = R"({"jsonrpc":"2.0","id":1,"method":"ping"})"
                                          "\n";

/// Movable. A connection that fails, or receives nothing for a minute, throws std::runtime_error.
class Client {
 public:
  /// To 127.0.0.1, with TCP_NODELAY.
  explicit Client(int port);
  Client(Client&& other) noexcept;
  Client& operator=(Client&&) = delete;
  ~Client();

  void send(std::string_view bytes);
  /// The next line without its LF.
  std::string line();
  /// Sends a line, with its LF, and returns the next line that is not a notification.
  std::string call(std::string_view request);
  /// Waits for `bytes` of any content.
  void skip(std::size_t bytes);
  int descriptor() const noexcept { return fd_; }

 private:
  void receive();

  int fd_;
  std::string read_;
};

/// Waits until a listener accepts there, at most a minute.
Client connect_when_listening(int port);
/// The body of http://127.0.0.1:port/path.
std::string http_get(int port, const std::string& path);

}  // namespace hedgehog::bench
