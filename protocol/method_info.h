// SPDX-License-Identifier: MIT
// Description of a method: the constant `kMethod` of its struct in protocol/methods.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "protocol/wire/error_set.h"
#include "protocol/wire/role.h"

namespace hedgehog::protocol {

struct MethodInfo {
  std::string_view name;
  /// Minimum role; nullopt: any client that can connect.
  std::optional<Role> role;
  /// One sentence for the OpenRPC document.
  std::string_view summary;
  /// In addition to those of `possible_errors`.
  ErrorSet errors{};
};

/// Possible errors of a request of `method`. Common to all: invalid parameters, busy (daemon
/// stopping or batch too long), and unauthorized (token required).
constexpr ErrorSet possible_errors(const MethodInfo& method) noexcept {
  const ErrorSet of_all{ErrorCode::kInvalidParams, ErrorCode::kBusy, ErrorCode::kUnauthorized};
  const ErrorSet of_role = method.role ? ErrorSet{ErrorCode::kForbidden} : ErrorSet{};
  return of_all | of_role | method.errors;
}

/// The methods of a namespace, as types.
template <class... Types>
struct TypeList {
  using Variant = std::variant<Types...>;
  template <class T>
  using With =
      std::conditional_t<(std::is_same_v<T, Types> || ...), TypeList, TypeList<Types..., T>>;
};

}  // namespace hedgehog::protocol
