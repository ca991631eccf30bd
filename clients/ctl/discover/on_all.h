// SPDX-License-Identifier: MIT
// One verb on several daemons at once.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clients/ctl/discover/local_daemons.h"

namespace hedgehog::client {

/// Runs `verb` on all of `daemons` at the same time, each in a child process, so that none waits
/// for another: a hung daemon does not delay the emergency stop of the others. Every line of their
/// stdout and stderr is printed at once, prefixed by "INSTANCE: "; with `as_json` a line of JSON on
/// stdout becomes {"instance":…,"address":…,"response":…}. Terminating signals are forwarded to the
/// children. Returns the highest exit code; kInternal for a child that was killed by a signal or
/// could not be started.
int run_on_all(const std::vector<LocalDaemon>& daemons, bool as_json,
               const std::function<int(const LocalDaemon&)>& verb);

}  // namespace hedgehog::client
