// SPDX-License-Identifier: MIT
#include "clients/lib/client_error.h"

#include <boost/throw_exception.hpp>
#include <stdexcept>

namespace hedgehog::client {

std::string reason_of(const boost::system::error_code& error) {
  std::string text = error.message();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] += 'a' - 'A';
  return text;
}

void throw_exception_from_error(const ClientError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

}  // namespace hedgehog::client
