// SPDX-License-Identifier: MIT
// Reading of JSON from other programs: no structure is assumed, nothing throws. Included by the
// importers only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"

namespace hedgehog::client {

using ForeignJson = protocol::Json;

/// The member `name` of an object; null if there is none.
const ForeignJson& member(const ForeignJson& json, std::string_view name) noexcept;
/// The items of the list `name`; none if it is not a list.
const ForeignJson::List& list(const ForeignJson& json, std::string_view name) noexcept;
bool is_object(const ForeignJson& json) noexcept;

/// The finite number `name`, clamped to `low`..`high`.
std::optional<double> number(const ForeignJson& json, std::string_view name, double low,
                             double high) noexcept;
/// The same; `fallback` if there is none.
double number(const ForeignJson& json, std::string_view name, double fallback, double low,
              double high) noexcept;
std::string text(const ForeignJson& json, std::string_view name);

/// `given` as a terminal and `pattern.put` accept it: no control characters, at most 200 bytes,
/// whole characters.
std::string one_line(std::string given);

}  // namespace hedgehog::client
