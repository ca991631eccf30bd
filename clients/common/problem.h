// SPDX-License-Identifier: MIT
// An error of a program: a sentence for the user and an exit code.
#pragma once

#include <sysexits.h>

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "clients/common/exit_code.h"

namespace hedgehog {

/// `exit_code` is one of sysexits.h; `message` one sentence, or a line for each error in a file.
/// Not an aggregate: an integer alone must not convert to it.
struct Problem {
  Problem() = default;
  Problem(int code, std::string what) : exit_code(code), message(std::move(what)) {}
  int exit_code = EX_SOFTWARE;
  std::string message{};
};

template <class T>
using Result = boost::system::result<T, Problem>;

/// Exception of `Result::value()`.
[[noreturn]] inline void throw_exception_from_error(const Problem& problem,
                                                    const boost::source_location&) {
  throw std::runtime_error(problem.message);
}

}  // namespace hedgehog
