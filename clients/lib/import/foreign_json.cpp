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
  if (const auto* whole = value.as<std::int64_t>()) {
    return std::clamp(static_cast<double>(*whole), low, high);
  }
  const auto* said = value.as<double>();
  return said != nullptr && std::isfinite(*said) ? std::optional(std::clamp(*said, low, high))
                                                 : std::nullopt;
}

double number(const ForeignJson& json, std::string_view name, double otherwise, double low,
              double high) noexcept {
  return number(json, name, low, high).value_or(otherwise);
}

std::string text(const ForeignJson& json, std::string_view name) {
  const auto* said = member(json, name).as<std::string>();
  return said == nullptr ? std::string() : *said;
}

std::string one_line(std::string said) {
  constexpr std::size_t kMost = 200;
  for (std::size_t i = 0; i < said.size(); ++i) {
    const auto byte = static_cast<unsigned char>(said[i]);
    if (byte < 0x20 || byte == 0x7f) {
      said[i] = ' ';
    } else if (byte == 0xc2 && i + 1 < said.size() &&
               static_cast<unsigned char>(said[i + 1]) < 0xa0) {
      said.replace(i, 2, " ");  // U+0080..U+009F
    }
  }
  std::size_t end = std::min(kMost, said.size());
  while (end > 0 && end < said.size() && (static_cast<unsigned char>(said[end]) & 0xC0u) == 0x80u) {
    --end;
  }
  said.resize(end);
  return said;
}

}  // namespace hedgehog::client
