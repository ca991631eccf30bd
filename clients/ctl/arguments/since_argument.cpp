// SPDX-License-Identifier: MIT
#include "clients/ctl/arguments/since_argument.h"

#include <array>
#include <charconv>
#include <ctime>
#include <optional>

#include "base/wall_time.h"

namespace hedgehog::client {
namespace {

constexpr std::int64_t kSecondMs = 1000;

struct Unit {
  std::string_view name;
  std::int64_t ms;
};
constexpr std::array kUnits{Unit{"s", kSecondMs}, Unit{"min", 60 * kSecondMs},
                            Unit{"h", 3600 * kSecondMs}, Unit{"d", 86'400 * kSecondMs}};
/// Longest time span: a century.
constexpr std::int64_t kMaxDays = 36'500;

/// "2h" in ms.
std::optional<std::int64_t> span_ms(std::string_view text) {
  std::int64_t count = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc() || count < 0) return std::nullopt;
  for (const Unit& unit : kUnits)
    if (unit.name == std::string_view(rest, end) && count <= kMaxDays * kUnits[3].ms / unit.ms)
      return count * unit.ms;
  return std::nullopt;
}

std::int64_t ms_of(std::tm local) {
  local.tm_isdst = -1;
  return static_cast<std::int64_t>(std::mktime(&local)) * kSecondMs;
}

int day_of(std::int64_t ms) {
  const std::time_t seconds = static_cast<std::time_t>(ms / kSecondMs);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  return local.tm_mday;
}

/// True if `format` matches the whole of `text`; then overwrites the fields of `local` that it
/// contains.
bool reads(const std::string& text, const char* format, std::tm& local) {
  std::tm read = local;
  const char* const rest = ::strptime(text.c_str(), format, &read);
  const bool all = rest != nullptr && *rest == '\0';
  local = all ? read : local;
  return all;
}

std::optional<std::int64_t> local_ms(const std::string& text, std::int64_t now_ms) {
  const std::time_t now = static_cast<std::time_t>(now_ms / kSecondMs);
  std::tm midnight{};
  ::localtime_r(&now, &midnight);
  midnight.tm_hour = midnight.tm_min = midnight.tm_sec = 0;
  std::tm yesterday = midnight;
  --yesterday.tm_mday;
  if (text == "today" || text == "yesterday") return ms_of(text == "today" ? midnight : yesterday);
  std::tm time = midnight;
  if (reads(text, "%H:%M", time) || reads(text, "%H:%M:%S", time)) {
    if (ms_of(time) > now_ms) --time.tm_mday;
    return ms_of(time);
  }
  std::tm day{};
  for (const char* format : {"%Y-%m-%d", "%Y-%m-%d %H:%M", "%Y-%m-%d %H:%M:%S"}) {
    if (reads(text, format, day)) {
      const std::int64_t ms = ms_of(day);
      return day_of(ms) == day.tm_mday ? std::optional(ms) : std::nullopt;  // no 31st of February
    }
  }
  return std::nullopt;
}

}  // namespace

Outcome<std::string> since_rfc3339(const std::string& text, std::int64_t now_ms) {
  if (const auto ago = span_ms(text)) return base::rfc3339(now_ms - *ago);
  if (const auto here = local_ms(text, now_ms)) return base::rfc3339(*here);
  if (const auto exact = base::parse_rfc3339(text)) return base::rfc3339(*exact);
  return ClientError{Failure::kBadAddress,
                     "since: '" + text +
                         "' is neither today or yesterday, nor so long ago (30min, 2h, 3d), nor a "
                         "time (23:14, 2026-11-20, 2026-11-20 23:14, 2026-11-20T23:14:07Z)",
                     {}};
}

}  // namespace hedgehog::client
