// SPDX-License-Identifier: MIT
// HTTP and WebSocket written byte by byte, so that a test can send invalid ones.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {

struct WebResponse {
  int status = 0;  // 0: closed without an answer
  std::string head;
  std::string body;
  /// Value of header `name`, in lower case; empty when it is missing.
  std::string header(std::string_view name) const;
};

/// One request on a connection of its own. `more`: header lines, each with CRLF.
WebResponse web_get(int port, const std::string& target, const std::string& more = "",
                    const std::string& method = "GET");
/// Sends `bytes`; returns the response.
WebResponse web_send(int port, std::string_view bytes);

class WebSocketClient {
 public:
  static constexpr int kText = 1;
  static constexpr int kBinary = 2;
  static constexpr int kClose = 8;
  static constexpr int kPing = 9;
  static constexpr int kPong = 10;

  /// Sends the opening handshake; `response()` has its response (101: accepted).
  explicit WebSocketClient(int port, const std::string& more = "");
  const WebResponse& response() const noexcept { return response_; }

  /// The bytes of one frame. `last`: final frame of its message.
  static std::string framed(int opcode, std::string_view payload, bool last);
  /// Sends one frame.
  bool frame(int opcode, std::string_view payload, bool last = true);
  bool text(std::string_view message) { return frame(kText, message); }

  struct Frame {
    int opcode = 0;
    std::string payload;
  };
  /// The next frame except pings, which are answered. nullopt: the daemon has closed, or has sent
  /// nothing else for minutes.
  std::optional<Frame> next();
  /// Sends a request and returns its result or error; notifications in between are skipped.
  Json call(const std::string& method, const Json& params = Json::object());
  Json json();
  RawClient& socket() noexcept { return socket_; }

 private:
  std::optional<Frame> any();

  RawClient socket_;
  WebResponse response_;
  int next_id_ = 0;
};

}  // namespace hedgehog::e2e
