// SPDX-License-Identifier: MIT
// Reading JSON that others wrote: nothing is taken for granted, nothing throws. Included by the
// importers only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"

namespace hedgehog::client {

using ForeignJson = protocol::Json;

/// The member `name` of an object; a null for anything else.
const ForeignJson& member(const ForeignJson& json, std::string_view name) noexcept;
/// The items of the list `name` there; none when it is no list.
const ForeignJson::List& list(const ForeignJson& json, std::string_view name) noexcept;
bool is_object(const ForeignJson& json) noexcept;

/// The finite number there, cut to `low`..`high`.
std::optional<double> number(const ForeignJson& json, std::string_view name, double low,
                             double high) noexcept;
/// The same; `otherwise` when there is none.
double number(const ForeignJson& json, std::string_view name, double otherwise, double low,
              double high) noexcept;
std::string text(const ForeignJson& json, std::string_view name);

/// What a terminal and `pattern.put` bear of it: no control characters, at most 200 bytes, whole
/// characters.
std::string one_line(std::string given);

}  // namespace hedgehog::client
