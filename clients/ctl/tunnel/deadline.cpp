// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/deadline.h"

#include <boost/system/error_code.hpp>
#include <utility>

namespace hedgehog::client {

void Deadline::start(std::chrono::milliseconds time, std::function<void()> expired) {
  stop();
  active_ = std::make_shared<bool>(true);
  timer_.expires_after(time);
  timer_.async_wait(
      [active = active_, call = std::move(expired)](const boost::system::error_code&) {
        // A handler that waits to be run is not cancelled together with the timer.
        if (std::exchange(*active, false)) call();
      });
}

void Deadline::stop() noexcept {
  if (active_ == nullptr) return;
  *std::exchange(active_, nullptr) = false;
  timer_.cancel();
}

}  // namespace hedgehog::client
