// SPDX-License-Identifier: MIT
// Signals that request the end of a program: Ctrl-C, SIGTERM, and the loss of its terminal.
#pragma once

namespace hedgehog::client {

/// Call once, at the start: from then on SIGINT, SIGTERM and SIGHUP interrupt blocking calls and do
/// not end the program.
void watch_interrupts();
/// True once one of them was received.
bool interrupted() noexcept;

}  // namespace hedgehog::client
