// SPDX-License-Identifier: MIT
// hello
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct HelloDevice {
  std::string name{};
  std::string model{};
  bool simulated = false;

  void describe(Fields& f);
  friend bool operator==(const HelloDevice&, const HelloDevice&) = default;
};

struct HelloLimits {
  double current_a = 15.0;
  double continuous_a = 5.0;
  double felt_a = 2.1;
  std::int64_t duration_ms = 10'000;
  std::int64_t lease_ms = 10'000;
  std::int64_t effects = 32;
  double frequency_hz = 250.0;
  double telemetry_hz = 200.0;
  std::int64_t line_bytes = 65'536;
  // Duration of current_a from ambient temperature, with this ball's measurement uncertainty;
  // omitted: unlimited.
  std::optional<double> burst_s{};

  void describe(Fields& f);
  friend bool operator==(const HelloLimits&, const HelloLimits&) = default;
};

struct HelloResult {
  static constexpr std::string_view kSchema = "Hello";
  std::string server{"hedgehogd"};
  std::string version{};
  std::string protocol{"1.0"};
  std::int64_t connection = 0;
  std::string start_id{};  // changes with each start of the daemon; empty: unknown
  Role role = Role::kObserve;
  std::string state{};
  std::optional<std::string> reason{};
  std::optional<std::string> remedy{};
  std::vector<std::string> methods{};  // empty: the encoder inserts all methods
  HelloDevice device{};
  HelloLimits limits{};

  void describe(Fields& f);
  friend bool operator==(const HelloResult&, const HelloResult&) = default;
};

struct Hello {
  static constexpr MethodInfo kMethod{"hello",
                                      std::nullopt,
                                      "Identifies the client; returns server, role and limits.",
                                      {ErrorCode::kUnsupported}};
  using Result = HelloResult;

  std::string client{};    // at most 128 characters, shown to the operator; empty: not given
  std::string protocol{};  // "1.0"; empty: not given
  std::optional<std::string> token{};

  void describe(Fields& f);
  friend bool operator==(const Hello&, const Hello&) = default;
};

using HelloMethods = TypeList<Hello>;

}  // namespace hedgehog::protocol
