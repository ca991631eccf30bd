// SPDX-License-Identifier: MIT
#include "daemon/server/device/event_wait.h"

#include <fcntl.h>

#include <algorithm>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <cerrno>
#include <system_error>

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// Asio closes its descriptors; the signal keeps its own.
int duplicate(int descriptor) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "F_DUPFD_CLOEXEC");
  return copy;
}

}  // namespace

EventWait::EventWait(asio::io_context& io, control::EventSignal& signal, const control::Pace& pace)
    : signal_(signal), pace_(pace), descriptor_(io, duplicate(signal.descriptor())), timer_(io) {
  watch();
}

void EventWait::watch() {
  descriptor_.async_wait(
      asio::posix::stream_descriptor::wait_read,
      [this](const error_code& ec) {
        if (ec) return;
        signal_.take();
        timer_.cancel();
        watch();
      });
}

asio::awaitable<void> EventWait::wait(model::Tick ticks) {
  // The next step may be due, and the snapshot nearly a step old.
  const std::chrono::milliseconds longest(ticks / pace_.speed - (pace_.step_ms - 1));
  timer_.expires_after(std::clamp(longest, kShortest, kLongest));
  error_code ignored;
  co_await timer_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
}

}  // namespace hedgehog::server
