// SPDX-License-Identifier: MIT
// Messages of one connection: the hello, requests with their responses, notifications.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/answer.h"
#include "core/transport.h"

namespace hedgehog::unreal {

/// One thread; no call blocks. Times are seconds of any monotonic clock.
class Session {
 public:
  /// Longest line accepted from the daemon.
  static constexpr std::size_t kMaxLine = std::size_t{4} << 20;
  /// Limit of unsent bytes while the daemon does not read.
  static constexpr std::size_t kMaxUnsent = std::size_t{1} << 20;
  static constexpr double kMaxRetryAfterS = 60.0;
  using OnNotification = std::function<void(const std::string& method, const Json& params)>;

  Session(std::unique_ptr<Transport> transport, Json introduction, double timeout_s, double now_s,
          OnNotification on_notification);

  /// Processes received data and timeouts.
  void poll(double now_s);
  void ask(const std::string& method, const Json& params, OnAnswer on_answer, double now_s);
  /// Without a response.
  void notify(const std::string& method, const Json& params);
  /// Ends the connection. Returns the callbacks of requests without a response.
  std::vector<OnAnswer> close(std::string reason);

  bool is_open() const { return hello_.is(Json::Kind::kObject) && ended_.empty(); }
  /// The peer, a daemon or another program, has sent data.
  bool was_reached() const { return reached_; }
  /// Why the connection has ended; empty: it is open.
  const std::string& ended() const { return ended_; }
  const Json& hello() const { return hello_; }
  /// JSON-RPC's error in response to the hello; null: none.
  const Json& refusal() const { return refusal_; }
  /// The daemon requests no connection earlier than after this time, at most `kMaxRetryAfterS`.
  double retry_after_s() const;

 private:
  struct Pending {
    std::int64_t id;
    std::string method;
    OnAnswer on_answer;
    double deadline_s;
  };
  void send(const std::string& method, const Json& params, std::int64_t id);
  void flush();
  void read();
  void take(std::string_view bytes);
  void take_line(const std::string& line);
  void take_introduction(const Json& message);
  void check_deadlines(double now_s);

  std::unique_ptr<Transport> transport_;
  Json introduction_;
  double timeout_s_;
  double deadline_s_;
  OnNotification on_notification_;
  std::string received_;
  std::string unsent_;
  std::string ended_;
  bool open_ = false;
  bool reached_ = false;
  bool writable_ = true;
  Json hello_;
  Json refusal_;
  /// Last message, if it is an error without an id: why the daemon closes the connection.
  Json notice_;
  std::int64_t last_id_ = 0;
  std::vector<Pending> pending_;
};

}  // namespace hedgehog::unreal
