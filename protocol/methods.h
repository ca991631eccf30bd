// SPDX-License-Identifier: MIT
// All methods of the protocol, joined from those of its namespaces; source of requests, results and
// the table by name. Other methods are rejected with -32601.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "protocol/method_info.h"
#include "protocol/methods/connection.h"
#include "protocol/methods/device.h"
#include "protocol/methods/done.h"
#include "protocol/methods/effect.h"
#include "protocol/methods/events.h"
#include "protocol/methods/hello.h"
#include "protocol/methods/orientation.h"
#include "protocol/methods/output.h"
#include "protocol/methods/pattern.h"
#include "protocol/methods/ping.h"
#include "protocol/methods/sim.h"
#include "protocol/methods/telemetry.h"
#include "protocol/methods/thermal.h"

namespace hedgehog::protocol {

namespace detail {

template <class... Lists>
struct Joined;
template <class... Types>
struct Joined<TypeList<Types...>> {
  using Type = TypeList<Types...>;
};
template <class... A, class... B, class... Rest>
struct Joined<TypeList<A...>, TypeList<B...>, Rest...> : Joined<TypeList<A..., B...>, Rest...> {};

template <class Seen, class... Rest>
struct DistinctResults {
  using Type = Seen;
};
template <class Seen, class First, class... Rest>
struct DistinctResults<Seen, First, Rest...>
    : DistinctResults<typename Seen::template With<typename First::Result>, Rest...> {};

template <class... Types>
DistinctResults<TypeList<Done>, Types...> results_of(TypeList<Types...>);

}  // namespace detail

/// A request is the struct of its method; its members are the parameters.
using Requests = detail::Joined<HelloMethods, PingMethods, ConnectionMethods, DeviceMethods,
                                EffectMethods, EventsMethods, OrientationMethods, OutputMethods,
                                PatternMethods, SimMethods, TelemetryMethods, ThermalMethods>::Type;
using Request = Requests::Variant;

/// The result of a successful request.
using Results = decltype(detail::results_of(Requests{}))::Type;
using ResultValue = Results::Variant;

/// The methods of the request type `R`: one, or those of EffectStart.
template <class R>
constexpr std::span<const MethodInfo> methods_of() noexcept {
  if constexpr (requires { R::kMethods; })
    return R::kMethods;
  else
    return {&R::kMethod, 1};
}

namespace detail {

template <class... Types>
constexpr auto sorted_methods(TypeList<Types...>) {
  std::array<MethodInfo, (methods_of<Types>().size() + ...)> sorted{};
  auto end = sorted.begin();
  ((end = std::copy(methods_of<Types>().begin(), methods_of<Types>().end(), end)), ...);
  std::sort(sorted.begin(), sorted.end(),
            [](const MethodInfo& a, const MethodInfo& b) { return a.name < b.name; });
  return sorted;
}

}  // namespace detail

/// Sorted by name. Also the content of `hello.methods`.
inline constexpr auto kMethods = detail::sorted_methods(Requests{});

/// An index into `kMethods`.
enum class Method : std::uint8_t {};

constexpr const MethodInfo& info(Method method) noexcept {
  return kMethods[static_cast<std::size_t>(method)];
}
constexpr std::string_view name(Method method) noexcept { return info(method).name; }

constexpr std::optional<Method> method_named(std::string_view text) noexcept {
  const auto* found = std::lower_bound(
      kMethods.begin(), kMethods.end(), text,
      [](const MethodInfo& row, std::string_view name) { return row.name < name; });
  if (found == kMethods.end() || found->name != text) return std::nullopt;
  return static_cast<Method>(found - kMethods.begin());
}

template <class R>
inline constexpr Method kMethodOf = *method_named(R::kMethod.name);

/// The method that `request` calls.
Method method_of(const Request& request) noexcept;
/// The request of `method` with default parameters.
Request empty_request(Method method);

}  // namespace hedgehog::protocol
