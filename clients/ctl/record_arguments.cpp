// SPDX-License-Identifier: MIT
#include "clients/ctl/record_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_record_arguments(const cli::CommandSpec& command, RecordOptions& options) {
  constexpr double kMinSeconds = 0.1;
  constexpr double kMinTolerance = 0.1;
  constexpr double kMaxTolerance = 45.0;
  command.add_option("file", options.file, "the pattern file to write").required();
  command.add_option("--seconds", options.seconds, "ends after this time; else with Ctrl-C")
      .range(kMinSeconds, kMaxRecordSeconds);
  command
      .add_option("--pointer", options.pointer, "what of the ball points: front, up, 34 or 90,20")
      .show_default();
  command.add_option("--tolerance-deg", options.tolerance_deg, "how far the pattern may be off")
      .range(kMinTolerance, kMaxTolerance)
      .show_default();
  command.add_option("--level", options.level, "of the push, 0..1").range(0.0, 1.0).show_default();
  command.add_option("--name", options.name, "of the pattern, vendor/name").show_default();
  command.add_flag("--force", options.replace, "replaces an existing file");
}

}  // namespace hedgehog::client
