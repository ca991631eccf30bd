// SPDX-License-Identifier: MIT
// The three ways in which programs use the C++ library, behind the same functions.
#pragma once

#include <future>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "clients/lib/ball.h"
#include "clients/lib/threaded_ball.h"

namespace hedgehog {

using client::ClientError;
using client::Failure;
using client::Milliseconds;

// Timeout of calls, and the duration of a case in which the daemon never answers.
inline constexpr Milliseconds kTimeout{60'000};

inline client::Outcome<std::string> outcome_of(protocol::Reply reply) {
  if (reply.result) return *std::move(reply.result);
  return ClientError{Failure::kRefused, reply.result.error().message, reply.result.error()};
}

/// A program that waits for each response.
class Waiting {
 public:
  static constexpr const char* kName = "C++ Ball";
  Waiting(const client::Address& address, BallOptions options)
      : ball_({address}, std::move(options)) {}

  client::Outcome<void> open() { return ball_.open(); }
  client::Outcome<std::string> call(const std::string& method, const std::string& params) {
    return ball_.call_raw(method, params);
  }
  bool request(const std::string& method) { return ball_.request_raw(method, "").has_value(); }
  client::Outcome<std::string> response() {
    for (;; std::this_thread::yield()) {
      if (auto reply = ball_.response()) return outcome_of(*std::move(reply));
      if (!ball_.connected()) return ball_.failure();
      ball_.update();
    }
  }
  bool notify(const std::string& method, const std::string& params) {
    return ball_.notify_raw(method, params);
  }
  bool rumble(const std::string& slot, double strength,
              std::optional<protocol::Direction> direction, protocol::EffectParams others) {
    ball_.update();
    return ball_.rumble(slot, strength, direction, std::move(others));
  }
  client::Notification next() { return ball_.next(kTimeout).value().value(); }
  std::optional<ClientError> refused_renewal() { return ball_.refused_renewal(); }
  int connections() { return ball_.connections(); }
  Milliseconds retry_after() { return ball_.retry_after(); }

 protected:
  Ball ball_;
};

/// A frame loop without a thread: no call blocks, not even to connect.
class Frames : public Waiting {
 public:
  static constexpr const char* kName = "C++ Ball, frames";
  using Waiting::Waiting;

  client::Outcome<void> open() {
    while (!ball_.connected() && ball_.problem().empty()) frame();
    if (ball_.connected()) return {};
    return ball_.failure();
  }
  client::Outcome<std::string> call(const std::string& method, const std::string& params) {
    while (!ball_.connected()) frame();
    const auto id = ball_.request_raw(method, params);
    for (;;) {
      if (!ball_.connected()) return ball_.failure();
      while (auto reply = ball_.response()) {
        if (reply->id != id) continue;
        return outcome_of(*std::move(reply));
      }
      frame();
    }
  }
  client::Notification next() {
    for (;;) {
      if (auto one = ball_.next()) return *std::move(one);
      frame();
    }
  }

 private:
  void frame() {
    ball_.update();
    std::this_thread::yield();
  }
};

/// A game with the library's thread: the calling thread polls, and waits only for futures.
class Threaded {
 public:
  static constexpr const char* kName = "C++ ThreadedBall";
  Threaded(const client::Address& address, BallOptions options)
      : ball_({address}, std::move(options)) {}

  client::Outcome<void> open() {
    for (;; std::this_thread::yield()) {
      if (ball_.connected()) return {};
      if (const auto failure = ball_.failure()) return *failure;
    }
  }
  client::Outcome<std::string> call(const std::string& method, const std::string& params) {
    return ball_.call_raw(method, params).get();
  }
  bool request(const std::string& method) {
    future_ = ball_.call_raw(method, "");
    return true;
  }
  client::Outcome<std::string> response() { return future_.get(); }
  std::optional<ClientError> refused_renewal() { return ball_.refused_renewal(); }
  bool notify(const std::string& method, const std::string& params) {
    return ball_.notify_raw(method, params);
  }
  bool rumble(const std::string& slot, double strength,
              std::optional<protocol::Direction> direction, protocol::EffectParams others) {
    return ball_.rumble(slot, strength, direction, std::move(others));
  }
  client::Notification next() {
    for (;; std::this_thread::yield())
      if (auto one = ball_.next()) return *std::move(one);
  }
  int connections() { return ball_.connections(); }
  // The library makes no attempt earlier than its back-off allows.
  Milliseconds retry_after() { return ThreadedBall::kReadInterval; }

 private:
  ThreadedBall ball_;
  std::future<client::Outcome<std::string>> future_;
};

}  // namespace hedgehog
