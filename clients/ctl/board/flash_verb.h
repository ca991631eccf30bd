// SPDX-License-Identifier: MIT
// `hedgehogctl board flash`: new firmware for the ball's board.
#pragma once

#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct FlashOptions {
  /// A UF2 file.
  std::string file;
  /// Only checks the file; no daemon is needed.
  bool check = false;
  /// Mount point of the boot loader's volume; empty: searched for.
  std::string volume;
  /// Timeout for the boot loader to be found, and for the daemon to detect the board again.
  double wait_s = 30.0;
};

/// Checks the file, requests the boot loader from the daemon, writes the file, and waits until the
/// daemon detects the board again. Returns the exit code.
int run_board_flash(const CommonOptions& common, const FlashOptions& options);

}  // namespace hedgehog::client
