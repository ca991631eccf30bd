// SPDX-License-Identifier: MIT
// `hedgehogctl demo`: plays the tour and shows it; its own smoke test.
#pragma once

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct DemoOptions {
  /// A daemon of its own on a simulated ball that starts warm, on a socket in a temporary folder.
  bool private_daemon = false;
  /// A real ball is about to be driven and its holder knows.
  bool confirmed = false;
};

/// 0 only when all chapters played, nothing tripped and the coils ended at zero; 130 when
/// interrupted (coils off).
int run_demo(const CommonOptions& common, const DemoOptions& options);

}  // namespace hedgehog::client
