// SPDX-License-Identifier: MIT
// A constant set of error codes: the possible errors of a method.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "protocol/wire/error.h"

namespace hedgehog::protocol {

/// All codes in the order of the protocol.
inline constexpr std::array kErrorCodes{
    ErrorCode::kParseError,     ErrorCode::kInvalidRequest, ErrorCode::kMethodNotFound,
    ErrorCode::kInvalidParams,  ErrorCode::kInternalError,  ErrorCode::kNotArmed,
    ErrorCode::kBusy,           ErrorCode::kNoSuchEffect,   ErrorCode::kUnauthorized,
    ErrorCode::kForbidden,      ErrorCode::kDeviceAbsent,   ErrorCode::kUnsupported,
    ErrorCode::kRefusedThermal, ErrorCode::kNoSuchPattern,  ErrorCode::kClaimed,
    ErrorCode::kArmed,
};

class ErrorSet {
 public:
  constexpr ErrorSet() noexcept = default;
  constexpr ErrorSet(std::initializer_list<ErrorCode> codes) noexcept {
    for (const ErrorCode code : codes) bits_ |= bit(code);
  }

  constexpr bool contains(ErrorCode code) const noexcept { return (bits_ & bit(code)) != 0; }
  friend constexpr ErrorSet operator|(ErrorSet a, ErrorSet b) noexcept {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  static constexpr std::uint32_t bit(ErrorCode code) noexcept {
    const auto* const found = std::find(kErrorCodes.begin(), kErrorCodes.end(), code);
    return found == kErrorCodes.end() ? 0U : 1U << (found - kErrorCodes.begin());
  }

  std::uint32_t bits_ = 0;
};

}  // namespace hedgehog::protocol
