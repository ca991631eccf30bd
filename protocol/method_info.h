// SPDX-License-Identifier: MIT
// What every method says of itself, as the constant `kMethod` of its struct in protocol/methods.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "protocol/wire/role.h"

namespace hedgehog::protocol {

struct MethodInfo {
  std::string_view name;
  /// The least role that may call it; none: anybody who can connect.
  std::optional<Role> role;
  /// One sentence, in the OpenRPC document.
  std::string_view summary;
};

/// The methods of a namespace, as types.
template <class... Types>
struct TypeList {
  using Variant = std::variant<Types...>;
  template <class T>
  using With =
      std::conditional_t<(std::is_same_v<T, Types> || ...), TypeList, TypeList<Types..., T>>;
};

}  // namespace hedgehog::protocol
