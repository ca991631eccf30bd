// SPDX-License-Identifier: MIT
#include "base/wall_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace hedgehog::base {
namespace {

namespace chrono = std::chrono;

constexpr std::int64_t kDayMs = 86'400'000;
constexpr std::int64_t kHourMs = 3'600'000;
constexpr std::int64_t kMinuteMs = 60'000;
constexpr std::int64_t kLastMs = 253'402'300'799'999;

/// Parses a text from its front; records a mismatch.
class Cursor {
 public:
  explicit Cursor(std::string_view text) noexcept : text_(text) {}

  int digits(std::size_t count) noexcept {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const char c = next();
      good_ = good_ && c >= '0' && c <= '9';
      value = value * 10 + (c - '0');
    }
    return good_ ? value : 0;
  }
  /// Next character if it is one of `any`, else 0.
  char one_of(std::string_view any) noexcept {
    const char c = next();
    good_ = good_ && any.find(c) != std::string_view::npos;
    return good_ ? c : '\0';
  }
  bool at_digit() const noexcept {
    return !text_.empty() && text_.front() >= '0' && text_.front() <= '9';
  }
  bool at(char c) const noexcept { return !text_.empty() && text_.front() == c; }
  bool at_end() const noexcept { return text_.empty(); }
  bool good() const noexcept { return good_; }

 private:
  char next() noexcept {
    if (text_.empty()) {
      good_ = false;
      return '\0';
    }
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }

  std::string_view text_;
  bool good_ = true;
};

std::int64_t fraction_ms(Cursor& cursor) noexcept {
  std::int64_t ms = 0;
  std::int64_t place = 100;
  cursor.one_of(".");
  ms += place * cursor.digits(1);
  while (cursor.good() && cursor.at_digit()) {
    place /= 10;
    ms += place * cursor.digits(1);
  }
  return ms;
}

}  // namespace

std::int64_t unix_ms_now() {
  const auto since_1970 = chrono::system_clock::now().time_since_epoch();
  return chrono::duration_cast<chrono::milliseconds>(since_1970).count();
}

std::string rfc3339(std::int64_t unix_ms) {
  const std::int64_t ms = std::clamp<std::int64_t>(unix_ms, 0, kLastMs);
  const chrono::year_month_day date{chrono::sys_days{chrono::days{ms / kDayMs}}};
  const chrono::hh_mm_ss time{chrono::milliseconds{ms % kDayMs}};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     time.hours().count(), time.minutes().count(), time.seconds().count(),
                     time.subseconds().count());
}

std::optional<std::int64_t> parse_rfc3339(std::string_view text) noexcept {
  Cursor c(text);
  const int year = c.digits(4);
  c.one_of("-");
  const int month = c.digits(2);
  c.one_of("-");
  const int day = c.digits(2);
  c.one_of("Tt ");
  const int hour = c.digits(2);
  c.one_of(":");
  const int minute = c.digits(2);
  c.one_of(":");
  const int second = c.digits(2);
  const std::int64_t ms = c.at('.') ? fraction_ms(c) : 0;
  const char zone = c.one_of("Zz+-");
  std::int64_t offset_ms = 0;
  if (zone == '+' || zone == '-') {
    const int hours = c.digits(2);
    c.one_of(":");
    const int minutes = c.digits(2);
    if (hours > 23 || minutes > 59) return std::nullopt;
    offset_ms = (zone == '+' ? 1 : -1) * (hours * kHourMs + minutes * kMinuteMs);
  }
  const chrono::year_month_day date{chrono::year{year}, chrono::month{static_cast<unsigned>(month)},
                                    chrono::day{static_cast<unsigned>(day)}};
  // Second 60 is a leap second.
  if (!c.good() || !c.at_end() || !date.ok() || hour > 23 || minute > 59 || second > 60)
    return std::nullopt;
  const std::int64_t days = chrono::sys_days{date}.time_since_epoch().count();
  return days * kDayMs + hour * kHourMs + minute * kMinuteMs + second * 1000LL + ms - offset_ms;
}

}  // namespace hedgehog::base
