// SPDX-License-Identifier: MIT
// Wall-clock times on the wire: RFC 3339, written in UTC, to the millisecond.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::base {

/// Milliseconds since 1970 by the system clock, which may be adjusted; never in the control path.
std::int64_t unix_ms_now();

/// "2026-11-20T23:14:07.412Z" of milliseconds since 1970, 0..253402300799999 (year 9999).
std::string rfc3339(std::int64_t unix_ms);

/// The inverse; also accepts no fraction or more digits (truncated to ms), lower case, a space
/// instead of T, and an offset instead of Z. nullopt: not RFC 3339, or no such date.
std::optional<std::int64_t> parse_rfc3339(std::string_view text) noexcept;

}  // namespace hedgehog::base
