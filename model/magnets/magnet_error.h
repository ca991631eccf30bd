// SPDX-License-Identifier: MIT
// Why an array of magnets cannot be made as asked.
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <string>

namespace hedgehog::model {

/// What of a ball's geometry an error is about.
enum class GeometryPart : std::uint8_t {
  kArrangement,
  kRemovedPins,
  kRemovedShields,
  kFrontPin,
  /// The magnets of pins, or those of pins and shields, on their sphere.
  kPinSizes,
  kAllSizes,
};

/// `message` is one sentence for a person, without full stop.
struct MagnetError {
  std::string message;
  GeometryPart part = GeometryPart::kArrangement;
};

/// Makes `MagnetResult<T>::value()` throw std::runtime_error with the message.
[[noreturn]] void throw_exception_from_error(const MagnetError& error,
                                             const boost::source_location& where);

template <class T>
using MagnetResult = boost::system::result<T, MagnetError>;

}  // namespace hedgehog::model
