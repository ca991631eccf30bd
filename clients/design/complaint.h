// SPDX-License-Identifier: MIT
// What went wrong, as a sentence for a person and a number for the shell (sysexits.h).
#pragma once

#include <boost/system/result.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace hedgehog::design {

enum ExitCode : int {
  kDone = 0,
  kUsage = 64,         // the command line
  kBadData = 65,       // a file, or magnets that cannot be where they were put
  kNoInput = 66,       // a file that is not there
  kUnavailable = 69,   // gnuplot or openscad is not installed
  kInternal = 70,      // a fault of this program
  kCannotCreate = 73,  // a file that cannot be written
  kToolFailed = 74,    // gnuplot or openscad ran and failed
};

struct Complaint {
  Complaint() = default;
  Complaint(int code, std::string what) : exit_code(code), sentence(std::move(what)) {}
  int exit_code = kUsage;
  std::string sentence;
};

template <class T>
using Result = boost::system::result<T, Complaint>;

/// What `Result::value()` throws.
[[noreturn]] inline void throw_exception_from_error(const Complaint& complaint,
                                                    const boost::source_location&) {
  throw std::runtime_error(complaint.sentence);
}

}  // namespace hedgehog::design
