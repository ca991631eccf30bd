// SPDX-License-Identifier: MIT
// The game's line to the daemon: found on the side, heard without waiting, found again when lost.
// Knows nothing of what is felt.
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/connection.h"

namespace hedgehog::racer {

/// One thread; no call waits for the daemon.
class BallLink {
 public:
  using Clock = std::chrono::steady_clock;
  /// A daemon that has told nothing for so long is taken for gone until it speaks.
  static constexpr std::chrono::milliseconds kSilent{500};

  struct Received {
    bool arrived = false;  // a new conversation began: what was asked before is never answered
    std::vector<protocol::Status> statuses{};
    std::vector<protocol::Reply> answers{};  // to `ask`
  };

  explicit BallLink(std::vector<client::Address> addresses);
  BallLink(const BallLink&) = delete;
  BallLink& operator=(const BallLink&) = delete;
  /// Waits for an attempt that is under way: a second, and `response_timeout` twice at most.
  ~BallLink();

  /// Once a frame: what has come since, and looks for the daemon where there is none.
  Received listen();
  /// Nothing: there is nobody to hear it.
  std::optional<protocol::Id> ask(const protocol::Request& request);
  void notify(const protocol::Request& request);

  /// It is there and not silent.
  bool hears() const;
  /// It is there, and silent or late with a response.
  bool is_late() const;
  /// Why it does not hear, one sentence; empty while the first attempt is under way.
  std::string trouble() const;
  /// Of this conversation: limits and role.
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
  bool timed_out_ = false;  // the last attempt
};

}  // namespace hedgehog::racer
