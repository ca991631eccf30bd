// SPDX-License-Identifier: MIT
// The verb that lists the balls of this machine and of the network.
#pragma once

namespace hedgehog::client {

/// Needs no connection. Returns kUnavailable if no ball is found.
int run_discover(bool as_json);

}  // namespace hedgehog::client
