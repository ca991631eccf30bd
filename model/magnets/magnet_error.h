// SPDX-License-Identifier: MIT
// Why an array of magnets cannot be made as asked.
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <string>

namespace hedgehog::model {

/// `message` is one sentence for a person, without full stop.
struct MagnetError {
  std::string message;
};

/// Makes `MagnetResult<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const MagnetError& error,
                                             const boost::source_location& where);

template <class T>
using MagnetResult = boost::system::result<T, MagnetError>;

}  // namespace hedgehog::model
