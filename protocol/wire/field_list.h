// SPDX-License-Identifier: MIT
// The fields of a value as a list, for generated documents and user interfaces.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

enum class FieldType : std::uint8_t {
  kBoolean,
  kNumber,
  kText,
  kEnumerator,
  kDirection,
  kList,
  kObject
};

struct FieldInfo {
  std::string name;
  FieldType type = FieldType::kObject;
  /// Bounds of a number, characters of a text.
  Spec spec{};
  /// Names of an enumerator.
  Names names{};
};

/// The fields of `describe` in its order, without the content of objects and lists. `describe` is
/// called with fields that are neither read nor written.
std::vector<FieldInfo> list_fields(const std::function<void(Fields&)>& describe);

}  // namespace hedgehog::protocol
