// SPDX-License-Identifier: MIT
// Requests since the start, by method and error.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "protocol/methods.h"
#include "protocol/wire/error_set.h"

namespace hedgehog::server {

/// io thread only. An array, because each request is counted.
class RequestCounts {
 public:
  /// One series of the metrics: method, "none" for an invalid request; error code, 0: carried out.
  struct Series {
    std::string_view method;
    int code = 0;
    std::uint64_t count = 0;
  };

  /// Counts a request of `method`, nullopt: not known; with its error, nullopt: carried out.
  void add(std::optional<protocol::Method> method,
           std::optional<protocol::ErrorCode> error) noexcept {
    ++counts_[method ? static_cast<std::size_t>(*method) : kNoMethod][column(error)];
  }

  /// Calls `report(Series)` for each possible error of each method and of decoding, also those that
  /// have not occurred: a rate would not include the first event of a new counter.
  template <class Report>
  void for_each(Report report) const {
    for (std::size_t row = 0; row <= kNoMethod; ++row) {
      if (row != kNoMethod) report(Series{name(row), 0, counts_[row][0]});
      for (const protocol::ErrorCode code : protocol::kErrorCodes) {
        const std::uint64_t count = counts_[row][column(code)];
        if (count > 0 || possible(row).contains(code))
          report(Series{name(row), static_cast<int>(code), count});
      }
    }
  }

  friend bool operator==(const RequestCounts&, const RequestCounts&) = default;

 private:
  static constexpr std::size_t kNoMethod = protocol::kMethods.size();

  static constexpr std::size_t column(std::optional<protocol::ErrorCode> error) noexcept {
    if (!error) return 0;
    const auto* const found =
        std::find(protocol::kErrorCodes.begin(), protocol::kErrorCodes.end(), *error);
    return 1 + static_cast<std::size_t>(found - protocol::kErrorCodes.begin());
  }
  static constexpr std::string_view name(std::size_t row) noexcept {
    return row == kNoMethod ? "none" : protocol::kMethods[row].name;
  }
  static constexpr protocol::ErrorSet possible(std::size_t row) noexcept {
    using protocol::ErrorCode;
    return row == kNoMethod
               ? protocol::ErrorSet{ErrorCode::kParseError, ErrorCode::kInvalidRequest,
                                    ErrorCode::kMethodNotFound, ErrorCode::kInvalidParams}
               : protocol::possible_errors(protocol::kMethods[row]);
  }

  /// Last row: no method. First column: no error; last column: codes that are not in the protocol.
  std::array<std::array<std::uint64_t, protocol::kErrorCodes.size() + 2>, kNoMethod + 1> counts_{};
};

}  // namespace hedgehog::server
