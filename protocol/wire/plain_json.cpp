// SPDX-License-Identifier: MIT
#include "protocol/wire/plain_json.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

namespace hedgehog::protocol {
namespace {

constexpr std::size_t kMaxMembers = 32;
constexpr std::ptrdiff_t kMaxWholeCharacters = 18;

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Each function parses at `at_`; false: not plain JSON.
class PlainParser {
 public:
  explicit PlainParser(std::string_view text) noexcept
      : at_(text.data()), end_(text.data() + text.size()) {}

  bool whole(Json& out, std::size_t levels) {
    if (!value(out, levels)) return false;
    skip_space();
    return at_ == end_;
  }

 private:
  bool value(Json& out, std::size_t levels) {
    skip_space();
    if (at_ == end_) return false;
    switch (*at_) {
      case '{':
        return levels > 0 && object(out.value.emplace<Json::Object>(), levels - 1);
      case '[':
        return levels > 0 && list(out.value.emplace<Json::List>(), levels - 1);
      case '"':
        return string(out.value.emplace<std::string>());
      case 't':
        out.value = true;
        return literal("true");
      case 'f':
        out.value = false;
        return literal("false");
      case 'n':
        return literal("null");
      default:
        return number(out);
    }
  }

  bool object(Json::Object& out, std::size_t levels) {
    ++at_;
    if (next_is('}')) return true;
    constexpr std::size_t kOfARequest = 4;
    out.reserve(kOfARequest);
    do {
      skip_space();
      std::string name;
      if (out.size() == kMaxMembers || !string(name) || has(out, name) || !next_is(':'))
        return false;
      if (!value(out.emplace_back(std::move(name), Json{}).second, levels)) return false;
    } while (next_is(','));
    return next_is('}');
  }

  bool list(Json::List& out, std::size_t levels) {
    ++at_;
    if (next_is(']')) return true;
    do {
      if (!value(out.emplace_back(), levels)) return false;
    } while (next_is(','));
    return next_is(']');
  }

  bool string(std::string& out) {
    if (at_ == end_ || *at_ != '"') return false;
    const char* const begin = ++at_;
    while (at_ != end_ && *at_ != '"') {
      const auto c = static_cast<unsigned char>(*at_++);
      if (c < 0x20 || c >= 0x80 || c == '\\') return false;
    }
    if (at_ == end_) return false;
    out.assign(begin, at_++);
    return true;
  }

  bool number(Json& out) {
    const char* const begin = at_;
    if (at_ != end_ && *at_ == '-') ++at_;
    const char* const first = at_;
    if (!digits() || (*first == '0' && at_ - first > 1)) return false;
    bool is_whole = true;
    if (at_ != end_ && *at_ == '.') {
      is_whole = false;
      ++at_;
      if (!digits()) return false;
    }
    if (at_ != end_ && (*at_ == 'e' || *at_ == 'E')) {
      is_whole = false;
      ++at_;
      if (at_ != end_ && (*at_ == '+' || *at_ == '-')) ++at_;
      if (!digits()) return false;
    }
    if (!is_whole) return convert(begin, out.value.emplace<double>());
    return at_ - first <= kMaxWholeCharacters && convert(begin, out.value.emplace<std::int64_t>());
  }

  template <class T>
  bool convert(const char* begin, T& out) noexcept {
    const auto result = std::from_chars(begin, at_, out);
    return result.ec == std::errc{} && result.ptr == at_;
  }

  bool digits() noexcept {
    const char* const begin = at_;
    while (at_ != end_ && is_digit(*at_)) ++at_;
    return at_ != begin;
  }

  bool literal(std::string_view text) noexcept {
    if (!std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(text))
      return false;
    at_ += text.size();
    return true;
  }

  bool next_is(char c) noexcept {
    skip_space();
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  void skip_space() noexcept {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\n' || *at_ == '\r')) ++at_;
  }

  static bool has(const Json::Object& object, std::string_view name) noexcept {
    return std::any_of(
        object.begin(), object.end(), [&](const auto& member) { return member.first == name; });
  }

  const char* at_;
  const char* end_;
};

}  // namespace

std::optional<Json> parse_plain_json(std::string_view text, std::size_t max_nesting) {
  std::optional<Json> json = Json{};
  if (!PlainParser(text).whole(*json, max_nesting)) json.reset();
  return json;
}

}  // namespace hedgehog::protocol
