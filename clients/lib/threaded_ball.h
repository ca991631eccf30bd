// SPDX-License-Identifier: MIT
// A Ball on its own thread: for games with irregular frames, or that play from several threads.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "clients/lib/ball.h"

namespace hedgehog {

/// Any thread; only the destructor blocks. Requests are sent at once, messages are read every
/// `kReadInterval`. A `call` delays the requests after it until its response.
class ThreadedBall {
 public:
  static constexpr client::Milliseconds kReadInterval{4};
  /// Limit of queued requests; more are refused.
  static constexpr std::size_t kMaxQueued = 1'000;

  /// Parameters as of `Ball`; begins to connect.
  explicit ThreadedBall(std::vector<client::Address> addresses, BallOptions options = {});
  /// Requests queued before are still sent. Waits for a call in progress.
  ~ThreadedBall();
  ThreadedBall(const ThreadedBall&) = delete;
  ThreadedBall& operator=(const ThreadedBall&) = delete;

  bool connected() const;
  /// As of `Ball`, at the last read. `failure`: nullopt: connected, or the first attempt is in
  /// progress.
  int connections() const;
  std::string problem() const;
  std::optional<client::ClientError> failure() const;
  /// As of `Ball`; false also when the queue is full.
  bool rumble(std::string_view slot, double strength,
              std::optional<protocol::Direction> direction = std::nullopt,
              protocol::EffectParams others = {});
  bool notify(protocol::Request request);
  bool notify_raw(std::string method, std::string params_json);
  /// The response or an error, later.
  template <class Request>
  std::future<client::Outcome<typename Request::Result>> call(Request request) {
    return later<typename Request::Result>(
        [request = std::move(request)](Ball& ball) { return ball.call(request); });
  }
  /// The same for any method; the result is the JSON text that the daemon sent.
  std::future<client::Outcome<std::string>> call_raw(std::string method, std::string params_json);
  std::optional<client::Notification> next();
  std::optional<client::ClientError> refused_renewal();

 private:
  using Task = std::function<void(Ball&)>;
  bool post(Task task);
  /// Runs `call` on the thread and returns its result.
  template <class Result, class Call>
  std::future<client::Outcome<Result>> later(Call call) {
    auto promise = std::make_shared<std::promise<client::Outcome<Result>>>();
    auto response = promise->get_future();
    const bool queued =
        post([promise, call = std::move(call)](Ball& ball) { promise->set_value(call(ball)); });
    if (!queued)
      promise->set_value(
          client::ClientError{client::Failure::kClosed, "too many requests are pending", {}});
    return response;
  }
  void run();

  mutable std::mutex mutex_;  // for all but ball_
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  std::deque<client::Notification> notifications_;
  std::deque<client::ClientError> refused_renewals_;
  bool connected_ = false;
  int connections_ = 0;
  std::optional<client::ClientError> failure_;
  bool ending_ = false;
  Ball ball_;  // used by the thread only
  std::thread thread_;
};

}  // namespace hedgehog
