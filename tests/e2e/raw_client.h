// SPDX-License-Identifier: MIT
// A client that is a plain socket, so that it can violate the protocol.
#pragma once

#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::e2e {

using Json = nlohmann::json;

/// Bytes of the longest line allowed by the protocol.
inline constexpr std::size_t kMaxLine = 65'536;

class RawClient {
 public:
  /// TCP on 127.0.0.1, or a Unix socket. `buffer`: approximate number of bytes that the system
  /// buffers until they are read; 0: the system's default.
  explicit RawClient(int port, int buffer = 0);
  explicit RawClient(const std::string& socket_path);
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { close(); }

  /// Sends the bytes unchanged. False when the daemon has closed.
  bool send(std::string_view bytes);
  /// The bytes received, at least one, or `count` when given; nullopt when the daemon has closed.
  std::optional<std::string> bytes(std::size_t count = 0);
  /// The next line; nullopt when the daemon has closed (or sends nothing for a minute).
  std::optional<std::string> line();
  /// The next line that is not a notification.
  Json response();
  /// Sends a request and returns its result, or its error.
  Json call(const std::string& method, const Json& params = Json::object());
  /// The params of the next notification `method` (of `type`, when given); others are skipped for
  /// up to ten minutes.
  Json notification(const std::string& method, const std::string& type = "");
  /// True if the daemon closes and sends nothing but notifications before.
  bool closed_by_daemon();
  /// Received TCP segments with data: as many as writes of the daemon, or fewer, because the system
  /// may join some.
  unsigned segments() const;
  void half_close();
  void close();

 private:
  bool receive();

  int fd_ = -1;
  std::string buffer_;
  std::deque<Json> notifications_;
  int next_id_ = 0;
};

}  // namespace hedgehog::e2e
