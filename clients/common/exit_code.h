// SPDX-License-Identifier: MIT
// Exit codes of the programs of clients/ (sysexits.h).
#pragma once

namespace hedgehog {

enum ExitCode : int {
  kDone = 0,
  kEndedOtherwise = 1,  // an effect ended with a reason other than completed
  kUsage = 64,          // usage error
  kBadData = 65,        // a file with invalid content, or an impossible set of magnets
  kNoInput = 66,        // a file that does not exist
  kUnavailable = 69,    // no daemon, no ball, not armed; gnuplot or openscad is not installed
  kInternal = 70,       // an internal error
  kCannotCreate = 73,   // a file that cannot be written, an address that cannot be bound
  kToolFailed = 74,     // gnuplot or openscad ran and failed
  kTryLater = 75,       // busy, too warm, claimed
  kProtocolError = 76,
  kNotAllowed = 77,  // insufficient role
  kInterrupted = 130,
};

}  // namespace hedgehog
