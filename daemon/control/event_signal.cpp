// SPDX-License-Identifier: MIT
#include "daemon/control/event_signal.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace hedgehog::control {

EventSignal::EventSignal() : descriptor_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

EventSignal::~EventSignal() { ::close(descriptor_); }

void EventSignal::raise() noexcept {
  if (!raised_.exchange(true, std::memory_order_acq_rel)) ::eventfd_write(descriptor_, 1);
}

void EventSignal::take() noexcept {
  eventfd_t count = 0;
  ::eventfd_read(descriptor_, &count);
  // In this order: a `raise` between the two makes no call, and its events are read after `take`.
  // In the other one the read could consume its signal, and no later `raise` would make a call.
  raised_.exchange(false, std::memory_order_acq_rel);
}

}  // namespace hedgehog::control
