// SPDX-License-Identifier: MIT
// Times of day on the wire: RFC 3339, in UTC when written, to the millisecond.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// Milliseconds since 1970 by the clock on the wall, which people may set; never in the control
/// path.
std::int64_t unix_ms_now();

/// "2026-11-20T23:14:07.412Z" of milliseconds since 1970, 0..253402300799999 (year 9999).
std::string rfc3339(std::int64_t unix_ms);

/// The inverse; also without a fraction or with more digits (cut to ms), in lower case, with a
/// space for the T, and with an offset for the Z. nullopt: not RFC 3339, or no such day.
std::optional<std::int64_t> parse_rfc3339(std::string_view text) noexcept;

}  // namespace hedgehog::base
