// SPDX-License-Identifier: MIT
// ping
#pragma once

#include <cstdint>

#include "protocol/method_info.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct PingResult {
  static constexpr std::string_view kSchema = "Ping";
  std::int64_t time_ns = 0;

  void describe(Fields& f) { f.required("time_ns", time_ns); }
  friend bool operator==(const PingResult&, const PingResult&) = default;
};

struct Ping {
  static constexpr MethodInfo kMethod{"ping", std::nullopt, "The device time."};
  using Result = PingResult;
  friend bool operator==(const Ping&, const Ping&) = default;
};

using PingMethods = TypeList<Ping>;

}  // namespace hedgehog::protocol
