// SPDX-License-Identifier: MIT
#include "clients/lib/client_error.h"

#include <boost/throw_exception.hpp>
#include <stdexcept>

namespace hedgehog::client {

void throw_exception_from_error(const ClientError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

}  // namespace hedgehog::client
