// SPDX-License-Identifier: MIT
#include "model/magnets/magnet_error.h"

#include <boost/throw_exception.hpp>
#include <stdexcept>

namespace hedgehog::model {

void throw_exception_from_error(const MagnetError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

}  // namespace hedgehog::model
