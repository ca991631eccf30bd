// SPDX-License-Identifier: MIT
// The game's connection to the daemon: established in the background, read without blocking,
// re-established when lost. Independent of the effects.
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/connection.h"

namespace hedgehog::racer {

/// One thread; no call blocks on the daemon.
class BallLink {
 public:
  using Clock = std::chrono::steady_clock;
  /// A daemon that has sent nothing for this long is considered silent until its next message.
  static constexpr std::chrono::milliseconds kSilent{500};

  struct Received {
    bool arrived = false;  // a new connection: earlier requests are never answered
    std::vector<protocol::Status> statuses{};
    std::vector<protocol::Reply> responses{};  // to `request`
  };

  explicit BallLink(std::vector<client::Address> addresses);
  BallLink(const BallLink&) = delete;
  BallLink& operator=(const BallLink&) = delete;
  /// Waits for an attempt in progress: a second, and `response_timeout` twice at most.
  ~BallLink();

  /// Once a frame: what was received since; connects if there is no connection.
  Received listen();
  /// nullopt: not connected, or no telemetry from the daemon.
  std::optional<protocol::Id> request(const protocol::Request& request);
  void notify(const protocol::Request& request);

  /// Connected and not silent.
  bool is_receiving() const;
  /// Connected and silent, or the last attempt timed out.
  bool is_late() const;
  /// Reason of a missing or silent connection, one sentence; empty during the first attempt.
  std::string problem() const;
  /// Of this connection: limits and role.
  const protocol::HelloResult& hello() const noexcept { return hello_; }

 private:
  struct Established {
    client::Connection daemon;
    protocol::HelloResult hello;
  };
  static client::Outcome<Established> arrive(const std::vector<client::Address>& addresses);
  bool poll_connect();
  void on_connection_lost(const client::ClientError& why);

  std::vector<client::Address> addresses_;
  std::future<client::Outcome<Established>> connecting_;
  client::Backoff backoff_;
  Clock::time_point next_attempt_{};
  std::optional<client::Connection> daemon_;
  protocol::HelloResult hello_{};
  Clock::time_point received_at_{};
  std::string problem_;
  bool timed_out_ = false;  // of the last attempt
};

}  // namespace hedgehog::racer
