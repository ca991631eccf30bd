// SPDX-License-Identifier: MIT
// `hedgehogctl demo`: plays the tour and shows it; also a smoke test.
#pragma once

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct DemoOptions {
  /// Uses its own daemon with a simulated ball that starts warm, on a socket in a temporary folder.
  bool private_daemon = false;
  /// The user has confirmed that a real ball may be driven.
  bool confirmed = false;
};

/// 0 only if all chapters played, nothing tripped and the coil currents ended at zero; 130 if
/// interrupted (coils off).
int run_demo(const CommonOptions& common, const DemoOptions& options);

}  // namespace hedgehog::client
