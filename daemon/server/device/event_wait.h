// SPDX-License-Identifier: MIT
// The pause of the io thread between two looks at the ball.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>

#include "daemon/control/event_signal.h"
#include "daemon/control/loop/pace.h"
#include "model/tick.h"

namespace hedgehog::server {

/// io thread only. `signal` outlives it; one at a time waits for it.
class EventWait {
 public:
  static constexpr std::chrono::milliseconds kShortest{1};
  static constexpr std::chrono::milliseconds kLongest{10};

  /// `pace`: of device time. Throws std::system_error.
  EventWait(boost::asio::io_context& io, control::EventSignal& signal, const control::Pace& pace);

  /// Returns `ticks` of device time after the latest snapshot, but not before kShortest nor after
  /// kLongest; when the signal is raised, at once.
  boost::asio::awaitable<void> wait(model::Tick ticks);

 private:
  void watch();

  control::EventSignal& signal_;
  control::Pace pace_;
  boost::asio::posix::stream_descriptor descriptor_;
  boost::asio::steady_timer timer_;
};

}  // namespace hedgehog::server
