// SPDX-License-Identifier: MIT
// Signals that ask a program to end: Ctrl-C, SIGTERM, and a terminal that went away.
#pragma once

namespace hedgehog::client {

/// Once, at the start: from there on SIGINT, SIGTERM and SIGHUP interrupt what waits and end
/// nothing.
void watch_interrupts();
/// True from the first of them on.
bool interrupted() noexcept;

}  // namespace hedgehog::client
