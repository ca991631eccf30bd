// SPDX-License-Identifier: MIT
// A client with nothing but a socket, so that it can misbehave.
#pragma once

#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::e2e {

using Json = nlohmann::json;

/// Bytes of the longest line that the protocol allows.
inline constexpr std::size_t kMaxLine = 65'536;

class RawClient {
 public:
  /// TCP on 127.0.0.1, or a Unix socket. `buffer`: about so many bytes wait in the system until
  /// they are read; 0: as many as it likes.
  explicit RawClient(int port, int buffer = 0);
  explicit RawClient(const std::string& socket_path);
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { close(); }

  /// Bytes as they are. False when the daemon has closed.
  bool send(std::string_view bytes);
  /// What has come, at least one byte, or, when given, `count` bytes; nullopt when the daemon has
  /// closed.
  std::optional<std::string> bytes(std::size_t count = 0);
  /// The next line; nullopt when the daemon has closed (or is silent for a minute).
  std::optional<std::string> line();
  /// The next line that is no notification.
  Json answer();
  /// Sends a request and returns its result, or its error.
  Json call(const std::string& method, const Json& params = Json::object());
  /// The params of the next notification `method` (of `type`, when given); others are skipped, for
  /// ten minutes.
  Json notification(const std::string& method, const std::string& type = "");
  /// The daemon closes without another word but notifications.
  bool closed_by_daemon();
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
