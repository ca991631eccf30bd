// SPDX-License-Identifier: MIT
#include "clients/ctl/flash_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_flash_arguments(const cli::CommandSpec& command, FlashOptions& options) {
  constexpr double kMaxWait = 600.0;
  command.add_option("file", options.file, "a UF2 file for the board's RP2040").required();
  command.add_flag("--check", options.check, "only looks at the file; no daemon is needed");
  command.add_option(
      "--volume", options.volume,
      "where RPI-RP2 is or will be mounted; else it is looked for, and picotool used");
  command
      .add_option("--wait-s", options.wait_s,
                  "for the boot loader to be found, and for the board to come back")
      .range(0.0, kMaxWait)
      .show_default();
}

}  // namespace hedgehog::client
