// SPDX-License-Identifier: MIT
#include "clients/common/interrupts.h"

#include <csignal>
#include <initializer_list>

namespace hedgehog::client {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void note_interrupt(int) { interrupt_seen = 1; }

}  // namespace

void watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool interrupted() noexcept { return interrupt_seen != 0; }

}  // namespace hedgehog::client
