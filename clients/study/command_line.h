// SPDX-License-Identifier: MIT
// Which verb of hedgehog-study, and its options.
#pragma once

namespace hedgehog::study {

/// The exit code: 0, one of sysexits.h, 75 for a run that was stopped and can be resumed, 130 when
/// interrupted.
int run_command_line(int argc, const char* const* argv);

}  // namespace hedgehog::study
