// SPDX-License-Identifier: MIT
// Exit codes of the programs: sysexits, and a shell's code for SIGINT.
#pragma once

#include <sysexits.h>

namespace hedgehog::e2e {

inline constexpr int kEndedOtherwise = 1;
inline constexpr int kUsage = EX_USAGE;
inline constexpr int kBadData = EX_DATAERR;
inline constexpr int kNoInput = EX_NOINPUT;
inline constexpr int kUnavailable = EX_UNAVAILABLE;
inline constexpr int kCannotCreate = EX_CANTCREAT;
inline constexpr int kTryLater = EX_TEMPFAIL;
inline constexpr int kConfig = EX_CONFIG;
inline constexpr int kInterrupted = 130;

}  // namespace hedgehog::e2e
