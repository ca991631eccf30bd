// SPDX-License-Identifier: MIT
// The fields of a value as a list, for what offers each of them to a person or a program.
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
  /// What an enumerator may be.
  Names names{};
};

/// What `describe` names, in its order; what is inside of objects and lists is left out. `describe`
/// is called with fields that are neither read nor written.
std::vector<FieldInfo> list_fields(const std::function<void(Fields&)>& describe);

}  // namespace hedgehog::protocol
