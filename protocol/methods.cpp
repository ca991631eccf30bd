// SPDX-License-Identifier: MIT
#include "protocol/methods.h"

#include <utility>

namespace hedgehog::protocol {
namespace {

using MakeRequest = Request (*)();

template <class R, std::size_t variety>
Request make_request() {
  if constexpr (std::is_same_v<R, EffectStart>)
    return EffectStart{.method = static_cast<model::EffectMethod>(variety)};
  else
    return R{};
}

template <class R, std::size_t... varieties>
constexpr void enter(std::array<MakeRequest, kMethods.size()>& table,
                     std::index_sequence<varieties...>) {
  ((table[static_cast<std::size_t>(*method_named(methods_of<R>()[varieties].name))] =
        make_request<R, varieties>),
   ...);
}

template <class... Types>
constexpr auto empty_requests(TypeList<Types...>) {
  std::array<MakeRequest, kMethods.size()> table{};
  (enter<Types>(table, std::make_index_sequence<methods_of<Types>().size()>()), ...);
  return table;
}

constexpr auto kEmptyRequests = empty_requests(Requests{});

}  // namespace

Method method_of(const Request& request) noexcept {
  return std::visit(
      []<class R>(const R& one) {
        if constexpr (std::is_same_v<R, EffectStart>)
          return *method_named(name(one.method));
        else
          return kMethodOf<R>;
      },
      request);
}

Request empty_request(Method method) { return kEmptyRequests[static_cast<std::size_t>(method)](); }

}  // namespace hedgehog::protocol
