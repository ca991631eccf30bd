// SPDX-License-Identifier: MIT
#include "clients/study/problem.h"

#include <stdexcept>

namespace hedgehog::study {

void throw_exception_from_error(const Problem& problem, const boost::source_location&) {
  throw std::runtime_error(problem.message);
}

}  // namespace hedgehog::study
