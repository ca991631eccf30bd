// SPDX-License-Identifier: MIT
// A Ball on a thread of its own: for games whose frames come irregularly, or that play from several
// threads.
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

/// Any thread; nothing waits but the destructor. What is sent goes at once, what comes is read
/// every `kReadInterval`. A `call` keeps what follows it waiting for its response.
class ThreadedBall {
 public:
  static constexpr client::Milliseconds kReadInterval{4};
  /// Requests that are not sent yet; more are refused.
  static constexpr std::size_t kMaxQueued = 1'000;

  /// As those of `Ball`; begins to connect.
  explicit ThreadedBall(std::vector<client::Address> addresses, BallOptions options = {});
  /// What was given before is still sent. Waits for a call that is under way.
  ~ThreadedBall();
  ThreadedBall(const ThreadedBall&) = delete;
  ThreadedBall& operator=(const ThreadedBall&) = delete;

  bool connected() const;
  /// As those of `Ball`, a moment ago. `failure`: nullopt: it is connected, or the first attempt is
  /// under way.
  int connections() const;
  std::string problem() const;
  std::optional<client::ClientError> failure() const;
  /// As of `Ball`; false also when too much is waiting to be sent.
  bool rumble(std::string_view slot, double strength,
              std::optional<protocol::Direction> direction = std::nullopt,
              protocol::EffectParams others = {});
  bool notify(protocol::Request request);
  bool notify_raw(std::string method, std::string params_json);
  /// The response, or why there is none, later.
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
  /// What `call` returns, on the thread.
  template <class Result, class Call>
  std::future<client::Outcome<Result>> later(Call call) {
    auto promise = std::make_shared<std::promise<client::Outcome<Result>>>();
    auto response = promise->get_future();
    const bool queued =
        post([promise, call = std::move(call)](Ball& ball) { promise->set_value(call(ball)); });
    if (!queued)
      promise->set_value(client::ClientError{client::Failure::kClosed, "too much is waiting", {}});
    return response;
  }
  void run();

  mutable std::mutex mutex_;  // of all but ball_
  std::condition_variable changed_;
  std::deque<Task> tasks_;
  std::deque<client::Notification> notifications_;
  std::deque<client::ClientError> refused_renewals_;
  bool connected_ = false;
  int connections_ = 0;
  std::optional<client::ClientError> failure_;
  bool ending_ = false;
  Ball ball_;  // of the thread
  std::thread thread_;
};

}  // namespace hedgehog
