// SPDX-License-Identifier: MIT
// Strict JSON parser on nlohmann's library: RFC 8259 does not allow a NUL between tokens (section
// 2), and in strings only escaped (section 7), but nlohmann's lexer treats one as the end of the
// text and ignores the rest. Header only: a layer that reads no JSON needs no library for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "base/nul_byte.h"

namespace hedgehog::base {

enum class JsonComments : std::uint8_t { kRefused, kAllowed };

template <class Json>
struct ParsedJson {
  /// Of type discarded if there is a `problem`.
  Json value;
  /// Error for a message: "has a NUL byte, which JSON never has", or the library's message. Empty:
  /// none.
  std::string problem{};
  /// Byte offset of the error.
  std::size_t at = 0;

  bool good() const noexcept { return problem.empty(); }
};

namespace detail {

/// Accepts all input and stores only the error.
template <class Json>
class JsonErrorFinder final : public Json::json_sax_t {
 public:
  using Sax = typename Json::json_sax_t;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(typename Sax::number_integer_t) override { return true; }
  bool number_unsigned(typename Sax::number_unsigned_t) override { return true; }
  bool number_float(typename Sax::number_float_t, const typename Sax::string_t&) override {
    return true;
  }
  bool string(typename Sax::string_t&) override { return true; }
  bool binary(typename Sax::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(typename Sax::string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&,
                   const typename Json::exception& error) override {
    at = position;
    what = error.what();
    // Removes the library's error number, "[json.exception.parse_error.101] ".
    if (const auto number = what.find("] "); number != std::string::npos) what.erase(0, number + 2);
    return false;
  }

  std::size_t at = 0;
  std::string what = "is no JSON";
};

}  // namespace detail

/// `Json`: nlohmann::json or nlohmann::ordered_json. Of duplicate members the last one is kept.
/// Throws nothing but std::bad_alloc.
template <class Json>
ParsedJson<Json> parse_json(std::string_view text, JsonComments comments = JsonComments::kRefused) {
  ParsedJson<Json> parsed{Json(Json::value_t::discarded)};
  if (const auto nul = first_nul(text)) {
    parsed.problem = kHasNul;
    parsed.at = *nul;
    return parsed;
  }
  const bool allowed = comments == JsonComments::kAllowed;
  parsed.value = Json::parse(text, nullptr, false, allowed);
  if (parsed.value.is_discarded()) {
    detail::JsonErrorFinder<Json> finder;
    Json::sax_parse(text, &finder, Json::input_format_t::json, true, allowed);
    parsed.problem = std::move(finder.what);
    parsed.at = finder.at;
  }
  return parsed;
}

}  // namespace hedgehog::base
