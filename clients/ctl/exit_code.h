// SPDX-License-Identifier: MIT
// What hedgehogctl tells the shell (sysexits.h), and how it says what went wrong.
#pragma once

#include "clients/lib/client_error.h"

namespace hedgehog::client {

enum ExitCode : int {
  kDone = 0,
  kEndedOtherwise = 1,  // an effect ended otherwise than completed
  kUsage = 64,
  kBadData = 65,
  kNoInput = 66,
  kUnavailable = 69,  // no daemon, no ball, or not armed
  kInternal = 70,
  kTryLater = 75,  // busy, too warm, claimed
  kProtocolError = 76,
  kNotAllowed = 77,  // the role does not suffice
  kInterrupted = 130,
};

ExitCode exit_code_of(const ClientError& error) noexcept;

/// Prints "hedgehogctl: <message>", and what to do about it where that is known, to stderr. Returns
/// `exit_code_of`.
ExitCode complain(const ClientError& error);

}  // namespace hedgehog::client
