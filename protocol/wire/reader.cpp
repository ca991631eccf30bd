// SPDX-License-Identifier: MIT
#include "protocol/wire/reader.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::protocol {
namespace {

std::size_t characters(std::string_view text) noexcept {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(),
      [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0u) !=
               0x80u;  // not a continuation byte of UTF-8
      }));
}

/// C0, DEL or C1 (U+0080..U+009F), which could forge log lines or move a terminal's cursor.
bool has_control_character(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20u || byte == 0x7fu) return true;
    if (byte == 0xc2u && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0u)
      return true;
  }
  return false;
}

/// The received value if it fits into `data.value`.
std::optional<ErrorValue> as_value(const Json& json) {
  if (const auto* flag = json.as<bool>()) return *flag;
  if (const auto* integer = json.as<std::int64_t>()) return *integer;
  if (const auto* number = json.as<double>()) return *number;
  constexpr std::size_t kShown = 256;
  if (const auto* text = json.as<std::string>(); text != nullptr && text->size() <= kShown)
    return *text;
  return std::nullopt;
}

}  // namespace

Reader::Reader(const Json& root, Strictness strictness, std::string_view what)
    : strict_(strictness == Strictness::kStrict), what_(what) {
  constexpr std::size_t kDepthOfARequest = 4;
  places_.reserve(kDepthOfARequest);
  places_.push_back({&root, {}});
}

Kind Reader::kind() const noexcept {
  constexpr Kind kKinds[] = {Kind::kNull,   Kind::kScalar, Kind::kScalar, Kind::kScalar,
                             Kind::kString, Kind::kList,   Kind::kObject};
  return kKinds[here().value.index()];
}

bool Reader::has(std::string_view name) const noexcept { return here().find(name) != nullptr; }

void Reader::fail(RpcError&& error) {
  if (!error_) error_ = std::move(error);
}

std::string Reader::path() const {
  std::string path;
  for (const Place& place : places_) {
    if (!path.empty() && !place.name.starts_with('[')) path += '.';
    path += place.name;
  }
  return path.empty() ? "params" : path;
}

std::string Reader::path_of(std::string_view member) const {
  const bool nested = places_.size() > 1;
  return nested ? path() + '.' + std::string(member) : std::string(member);
}

void Reader::wrong_type(std::string_view wanted) {
  const std::string field = path();
  RpcError error = invalid_params(
      field, "must be " + std::string(wanted) + ", not " + std::string(here().kind()));
  error.value = as_value(here());
  fail(std::move(error));
}

bool Reader::open(std::string_view name, Presence presence, bool) {
  Place& place = places_.back();
  place.known.push_back(name);
  const Json* member = place.json->find(name);
  if (member == nullptr) {
    if (strict_ && presence == Presence::kRequired) {
      const std::string field = path_of(name);
      fail(invalid_params(field, "is missing"));
    }
    return false;
  }
  if (!strict_ && member->as<std::nullptr_t>() != nullptr) return false;
  places_.push_back({member, std::string(name)});
  return true;
}

void Reader::close() { places_.pop_back(); }

bool Reader::begin_object() {
  if (here().as<Json::Object>() == nullptr) {
    wrong_type("an object");
    return false;
  }
  constexpr std::size_t kFieldsOfARequest = 32;
  places_.back().known.clear();
  places_.back().known.reserve(kFieldsOfARequest);
  return true;
}

void Reader::end_object() {
  if (!strict_) return;
  const Place& place = places_.back();
  for (const auto& [name, member] : *place.json->as<Json::Object>()) {
    if (std::find(place.known.begin(), place.known.end(), name) == place.known.end()) {
      const std::string of = places_.size() > 1 ? path() : std::string(what_);
      RpcError error = invalid_params(path_of(shortened(name)),
                                      "is not a parameter of " + of + hint(name, place.known));
      error.value = as_value(member);
      fail(std::move(error));
      return;
    }
  }
}

std::size_t Reader::begin_list(std::size_t, const Spec& spec) {
  const auto* list = here().as<Json::List>();
  if (list == nullptr) {
    wrong_type("a list");
    return 0;
  }
  if (strict_ && list->size() > spec.items) {
    const std::string field = path();
    RpcError error =
        out_of_range(field, static_cast<double>(spec.items), static_cast<double>(list->size()));
    error.message = field + ": has " + std::to_string(list->size()) + " items, more than " +
                    std::to_string(spec.items);
    fail(std::move(error));
    return 0;
  }
  return list->size();
}

bool Reader::begin_item(std::size_t index) {
  places_.push_back({&(*here().as<Json::List>())[index], '[' + std::to_string(index) + ']'});
  return true;
}

void Reader::boolean(bool& v) {
  if (const auto* flag = here().as<bool>())
    v = *flag;
  else
    wrong_type("true or false");
}

std::optional<double> Reader::number_in_range(const Json& json, const Spec& spec) {
  double value = 0.0;
  if (const auto* integer = json.as<std::int64_t>()) {
    value = static_cast<double>(*integer);
  } else if (const auto* number = json.as<double>()) {
    value = *number;
  } else {
    wrong_type("a number");
    return std::nullopt;
  }
  if (!(value >= spec.min && value <= spec.max)) {
    fail(out_of_range(path(), value > spec.max ? spec.max : spec.min, value));
    return std::nullopt;
  }
  return value;
}

void Reader::integer(std::int64_t& v, const Spec& spec) {
  const std::optional<double> value = number_in_range(here(), spec);
  if (!value) return;
  if (const auto* exact = here().as<std::int64_t>()) {
    v = *exact;
    return;
  }
  const double rounded = std::round(*value);
  constexpr double kExact = 9'223'372'036'854'774'784.0;  // the largest double below 2^63
  if ((!spec.rounded && rounded != *value) || std::fabs(rounded) > kExact) {
    RpcError error = invalid_params(path(), "must be a whole number");
    error.value = *value;
    fail(std::move(error));
    return;
  }
  v = static_cast<std::int64_t>(rounded);
}

void Reader::number(double& v, const Spec& spec) {
  if (const std::optional<double> value = number_in_range(here(), spec)) v = *value;
}

void Reader::text(std::string& v, const Spec& spec) {
  const auto* text = here().as<std::string>();
  if (text == nullptr) {
    wrong_type("a string");
    return;
  }
  const auto length = static_cast<double>(characters(*text));
  if (length < spec.min || length > spec.max) {
    const bool longer = length > spec.max;
    const double limit = longer ? spec.max : spec.min;
    RpcError error = out_of_range(path(), limit, length);
    error.message = path() + ": has " + std::to_string(characters(*text)) + " characters, " +
                    (longer ? "more" : "fewer") + " than " +
                    std::to_string(static_cast<int>(limit));
    fail(std::move(error));
    return;
  }
  if (strict_ && has_control_character(*text)) {
    fail(invalid_params(path(), "has a control character"));
    return;
  }
  v = *text;
}

void Reader::enumerator(std::size_t& index, std::span<const std::string_view> names) {
  const auto* text = here().as<std::string>();
  if (text == nullptr) {
    wrong_type("a string");
    return;
  }
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) {
    index = static_cast<std::size_t>(found - names.begin());
    return;
  }
  if (strict_) {
    RpcError error =
        invalid_params(path(), "there is no '" + shortened(*text) + "'" + hint(*text, names));
    error.value = as_value(here());
    fail(std::move(error));
  }
}

void Reader::numbers(std::span<double> v, const Spec& spec) {
  const auto* list = here().as<Json::List>();
  const auto wanted = [&] { return "a list of " + std::to_string(v.size()) + " numbers"; };
  if (list == nullptr) {
    wrong_type(wanted());
    return;
  }
  if (list->size() != v.size()) {
    fail(
        invalid_params(path(), "must be " + wanted() + ", not of " + std::to_string(list->size())));
    return;
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    begin_item(i);
    if (const std::optional<double> value = number_in_range(here(), spec)) v[i] = *value;
    close();
  }
}

}  // namespace hedgehog::protocol
