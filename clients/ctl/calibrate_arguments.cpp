// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_calibrate_arguments(const cli::CommandSpec& command, CalibrateOptions& options) {
  command.add_option("--out", options.out, "the device file to write").required();
  command.add_option("--name", options.name, "of the ball; default: its present name");
  command.add_option("--current-a", options.current_a, "ampere, 0.5..5")
      .range(0.5, 5.0)
      .show_default();
  command
      .add_option("--pushed", options.pushed,
                  "which side each winding pushes, instead of asking: x=front,y=left,z=up")
      .delimiter(',');
  command.add_flag("--thermal", options.thermal,
                   "also heats and cools the ball for half an hour, for its thermal constants");
  command.add_flag("--force", options.force,
                   "replaces an existing file; accepts a ball that is not at one temperature");
}

}  // namespace hedgehog::client
