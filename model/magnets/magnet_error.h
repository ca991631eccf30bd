// SPDX-License-Identifier: MIT
// Error of an array of magnets that cannot be built.
#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <string>

namespace hedgehog::model {

/// The part of a ball's geometry to which an error refers.
enum class GeometryPart : std::uint8_t {
  kArrangement,
  kRemovedPins,
  kRemovedShields,
  kFrontPin,
  /// Sizes of the pins' magnets, or of pins, shields and sphere.
  kPinSizes,
  kAllSizes,
};

/// `message` is one human-readable sentence without full stop.
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
