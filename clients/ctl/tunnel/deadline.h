// SPDX-License-Identifier: MIT
// A limit on the duration of an operation of a tunnel.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <memory>

namespace hedgehog::client {

/// One at a time. io thread only.
class Deadline {
 public:
  explicit Deadline(const boost::asio::any_io_executor& executor) : timer_(executor) {}
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;
  ~Deadline() { stop(); }

  /// Calls `expired` after `time`, unless `start` or `stop` is called before, or this is destroyed.
  void start(std::chrono::milliseconds time, std::function<void()> expired);
  /// From now on `expired` is not called, even if the time has passed.
  void stop() noexcept;

 private:
  boost::asio::steady_timer timer_;
  std::shared_ptr<bool> active_;
};

}  // namespace hedgehog::client
