// SPDX-License-Identifier: MIT
#include "protocol/wire/plain_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string>
#include <system_error>
#include <tuple>
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

  bool request(PlainRequest& out, std::size_t levels) {
    if (levels == 0 || !next_is('{')) return false;
    std::array<std::string_view, kMaxMembers> names;
    std::size_t count = 0;
    do {
      if (count == kMaxMembers) return false;
      std::string_view& name = names[count];
      skip_space();
      if (!text_of(name) || !next_is(':')) return false;
      const std::span<const std::string_view> before(names.data(), count++);
      if (std::find(before.begin(), before.end(), name) != before.end()) return false;
      if (!member_of_request(out, name, levels - 1)) return false;
    } while (next_is(','));
    if (!next_is('}')) return false;
    skip_space();
    return at_ == end_;
  }

 private:
  bool member_of_request(PlainRequest& out, std::string_view name, std::size_t levels) {
    skip_space();
    if (name == "jsonrpc") return text_of(out.version);
    if (name == "method") return text_of(out.method);
    if (name == "id") return value(out.id.emplace(Json{}), levels);
    if (name == "params") return value(out.params.emplace(Json{}), levels);
    Json ignored;
    return value(ignored, levels);
  }

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
      if (out.size() == kMaxMembers) return false;
      // In place: a pair with a Json is not default-constructible inside Json.
      auto& [name, member] =
          out.emplace_back(std::piecewise_construct, std::tuple<>(), std::tuple<>());
      skip_space();
      if (!string(name) || last_is_repeated(out) || !next_is(':') || !value(member, levels))
        return false;
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
    std::string_view text;
    if (!text_of(text)) return false;
    out = text;
    return true;
  }

  bool text_of(std::string_view& out) noexcept {
    if (at_ == end_ || *at_ != '"') return false;
    const char* const begin = ++at_;
    while (at_ != end_ && *at_ != '"') {
      const auto c = static_cast<unsigned char>(*at_++);
      if (c < 0x20 || c >= 0x80 || c == '\\') return false;
    }
    if (at_ == end_) return false;
    out = {begin, static_cast<std::size_t>(at_++ - begin)};
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

  static bool last_is_repeated(const Json::Object& object) noexcept {
    const std::string& name = object.back().first;
    return std::any_of(object.begin(), object.end() - 1,
                       [&](const auto& member) { return member.first == name; });
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

std::optional<PlainRequest> parse_plain_request(std::string_view text, std::size_t max_nesting) {
  std::optional<PlainRequest> request = PlainRequest{};
  const bool good = PlainParser(text).request(*request, max_nesting);
  if (!good || request->version.data() == nullptr || request->method.data() == nullptr)
    request.reset();
  return request;
}

}  // namespace hedgehog::protocol
