// SPDX-License-Identifier: MIT
// What hedgehog-study cannot do, as a sentence and an exit code.
#pragma once

#include <sysexits.h>

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <string>

namespace hedgehog::study {

/// `exit_code` is one of sysexits.h; `message` one sentence, or a line for each mistake in a file.
struct Problem {
  int exit_code = EX_SOFTWARE;
  std::string message{};
};

/// Makes `Result<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const Problem& problem,
                                             const boost::source_location& where);

template <class T>
using Result = boost::system::result<T, Problem>;

}  // namespace hedgehog::study
