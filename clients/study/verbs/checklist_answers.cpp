// SPDX-License-Identifier: MIT
#include "clients/study/verbs/checklist_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace hedgehog::study {

namespace {

constexpr double kSmallestHandCm = 10.0;
constexpr double kLargestHandCm = 30.0;
constexpr int kOldestYears = 120;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// All of `text` as a number.
template <class Number, class... Format>
std::optional<Number> number_of(std::string_view text, Format... format) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, format...);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

std::optional<int> years_of(std::string_view text) {
  const auto years = number_of<int>(text);
  return years && *years >= 0 && *years <= kOldestYears && text.front() != '-' ? years
                                                                               : std::nullopt;
}

}  // namespace

Result<double> parse_hand_size(std::string_view text) {
  const std::string_view given = trimmed(text);
  const auto size = number_of<double>(given, std::chars_format::fixed);
  if (size && *size >= kSmallestHandCm && *size <= kLargestHandCm) return *size;
  std::string with_point(given);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool comma = with_point != given &&
                     number_of<double>(std::string_view(with_point), std::chars_format::fixed);
  return Problem{EX_USAGE,
                 comma ? fmt::format("hand size: write {} with a point, {}", given, with_point)
                       : fmt::format("hand size: a number between {:g} and {:g} cm, not \"{}\"",
                                     kSmallestHandCm, kLargestHandCm, given)};
}

Result<std::string> parse_age_band(std::string_view text) {
  const std::string_view given = trimmed(text);
  if (given.empty()) return std::string();
  const auto dash = given.find('-');
  const bool open = given.ends_with('+');
  const auto from = years_of(given.substr(0, open ? given.size() - 1 : dash));
  const auto to = open                             ? std::optional(kOldestYears)
                  : dash == std::string_view::npos ? std::nullopt
                                                   : years_of(given.substr(dash + 1));
  if (from && to && *from < *to) return std::string(given);
  return Problem{EX_USAGE,
                 fmt::format("age band: two ages such as 22-29, or one and above such as 70+, not "
                             "\"{}\"",
                             given)};
}

std::optional<bool> parse_yes_no(std::string_view text) {
  std::string word(trimmed(text));
  std::transform(word.begin(), word.end(), word.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (word == "y" || word == "yes") return true;
  if (word == "n" || word == "no") return false;
  return std::nullopt;
}

}  // namespace hedgehog::study
