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
    std::vector<protocol::Reply> answers{};  // to `ask`
  };

  explicit BallLink(std::vector<client::Address> addresses);
  BallLink(const BallLink&) = delete;
  BallLink& operator=(const BallLink&) = delete;
  /// Waits for an attempt in progress: a second, and `response_timeout` twice at most.
  ~BallLink();

  /// Once a frame: what was received since; connects if there is no connection.
  Received listen();
  /// nullopt: not connected, or the daemon is silent.
  std::optional<protocol::Id> ask(const protocol::Request& request);
  void notify(const protocol::Request& request);

  /// Connected and not silent.
  bool hears() const;
  /// Connected and silent, or the last attempt timed out.
  bool is_late() const;
  /// Reason of a missing or silent connection, one sentence; empty during the first attempt.
  std::string trouble() const;
  /// Of this connection: limits and role.
  const protocol::HelloResult& hello() const noexcept { return hello_; }

 private:
  struct Arrival {
    client::Connection daemon;
    protocol::HelloResult hello;
  };
  static client::Outcome<Arrival> arrive(const std::vector<client::Address>& addresses);
  bool look_for_the_daemon();
  void lose_the_daemon(const client::ClientError& why);

  std::vector<client::Address> addresses_;
  std::future<client::Outcome<Arrival>> arriving_;
  client::Backoff backoff_;
  Clock::time_point next_try_{};
  std::optional<client::Connection> daemon_;
  protocol::HelloResult hello_{};
  Clock::time_point received_at_{};
  std::string trouble_;
  bool timed_out_ = false;  // of the last attempt
};

}  // namespace hedgehog::racer
