// SPDX-License-Identifier: MIT
// The command line of hedgehog-study: verbs and their options.
#pragma once

namespace hedgehog::study {

/// Returns the exit code: 0, one of sysexits.h, 75 for a run that was stopped and can be resumed,
/// 130 if interrupted.
int run_command_line(int argc, const char* const* argv);

}  // namespace hedgehog::study
