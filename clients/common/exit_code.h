// SPDX-License-Identifier: MIT
// What the programs of clients/ tell the shell (sysexits.h).
#pragma once

namespace hedgehog {

enum ExitCode : int {
  kDone = 0,
  kEndedOtherwise = 1,  // an effect ended otherwise than completed
  kUsage = 64,          // the command line
  kBadData = 65,        // a file that is not what it should be, or magnets that cannot be there
  kNoInput = 66,        // a file that is not there
  kUnavailable = 69,    // no daemon, no ball, not armed; gnuplot or openscad is not installed
  kInternal = 70,       // a fault of the program
  kCannotCreate = 73,   // a file that cannot be written, an address that cannot be listened at
  kToolFailed = 74,     // gnuplot or openscad ran and failed
  kTryLater = 75,       // busy, too warm, claimed
  kProtocolError = 76,
  kNotAllowed = 77,  // the role does not suffice
  kInterrupted = 130,
};

}  // namespace hedgehog
