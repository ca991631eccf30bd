// SPDX-License-Identifier: MIT
// What every method says of itself, as the constant `kMethod` of its struct in protocol/methods.
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
  /// The least role that may call it; none: anybody who can connect.
  std::optional<Role> role;
  /// One sentence, in the OpenRPC document.
  std::string_view summary;
  /// Beyond those that `possible_errors` adds.
  ErrorSet errors{};
};

/// What a request of `method` may be refused with: parameters are checked for all, a daemon that is
/// stopping or a batch that is too long is busy for all, and where a token is needed, it is for
/// all.
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
