// SPDX-License-Identifier: MIT
// `hedgehogctl board flash`: new firmware for the board of the ball.
#pragma once

#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct FlashOptions {
  /// A UF2 file.
  std::string file;
  /// Only looks at the file; no daemon is needed.
  bool check = false;
  /// Where the boot loader's volume is mounted; empty: it is looked for.
  std::string volume;
  /// For the boot loader to be found, and for the daemon to see the board again.
  double wait_s = 30.0;
};

/// Checks the file, asks the daemon to send the board into its boot loader, writes, and waits until
/// the daemon sees the board again. Returns the exit code.
int run_board_flash(const CommonOptions& common, const FlashOptions& options);

}  // namespace hedgehog::client
