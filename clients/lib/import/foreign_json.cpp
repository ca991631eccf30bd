// SPDX-License-Identifier: MIT
#include "clients/lib/import/foreign_json.h"

#include <algorithm>
#include <cmath>

namespace hedgehog::client {

const ForeignJson& member(const ForeignJson& json, std::string_view name) noexcept {
  static const ForeignJson kNone;
  const ForeignJson* found = json.find(name);
  return found == nullptr ? kNone : *found;
}

const ForeignJson::List& list(const ForeignJson& json, std::string_view name) noexcept {
  static const ForeignJson::List kEmpty;
  const auto* found = member(json, name).as<ForeignJson::List>();
  return found == nullptr ? kEmpty : *found;
}

bool is_object(const ForeignJson& json) noexcept {
  return json.as<ForeignJson::Object>() != nullptr;
}

std::optional<double> number(const ForeignJson& json, std::string_view name, double low,
                             double high) noexcept {
  const ForeignJson& value = member(json, name);
  if (const auto* whole = value.as<std::int64_t>())
    return std::clamp(static_cast<double>(*whole), low, high);
  const auto* given = value.as<double>();
  return given != nullptr && std::isfinite(*given) ? std::optional(std::clamp(*given, low, high))
                                                   : std::nullopt;
}

double number(const ForeignJson& json, std::string_view name, double fallback, double low,
              double high) noexcept {
  return number(json, name, low, high).value_or(fallback);
}

std::string text(const ForeignJson& json, std::string_view name) {
  const auto* given = member(json, name).as<std::string>();
  return given == nullptr ? std::string() : *given;
}

std::string one_line(std::string given) {
  constexpr std::size_t kMaxShown = 200;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto byte = static_cast<unsigned char>(given[i]);
    if (byte < 0x20 || byte == 0x7f)
      given[i] = ' ';
    else if (byte == 0xc2 && i + 1 < given.size() &&
             static_cast<unsigned char>(given[i + 1]) < 0xa0)
      given.replace(i, 2, " ");  // U+0080..U+009F
  }
  std::size_t end = std::min(kMaxShown, given.size());
  while (end > 0 && end < given.size() && (static_cast<unsigned char>(given[end]) & 0xC0u) == 0x80u)
    --end;
  given.resize(end);
  return given;
}

}  // namespace hedgehog::client
