// SPDX-License-Identifier: MIT
// thermal.*
#pragma once

#include <optional>

#include "protocol/method_info.h"
#include "protocol/methods/effect.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

/// null: never, or no recovery needed. While the temperature is not known no current is allowed:
/// derating at once, nothing sustainable; null then means unknown.
struct ForecastResult {
  static constexpr std::string_view kSchema = "Forecast";
  std::optional<double> seconds_to_derating{};
  std::optional<double> seconds_to_limit{};
  double sustainable_a = 0.0;
  std::optional<double> recovery_s{};
  bool temperature_known = true;  // true if omitted (older daemon)

  void describe(Fields& f) {
    f.nullable("seconds_to_derating", seconds_to_derating, decimals(1));
    f.nullable("seconds_to_limit", seconds_to_limit, decimals(1));
    f.required("sustainable_a", sustainable_a, decimals(2));
    f.nullable("recovery_s", recovery_s, decimals(1));
    f.required("temperature_known", temperature_known);
  }
  friend bool operator==(const ForecastResult&, const ForecastResult&) = default;
};

/// Exactly one of `current_a`, `start` and `effect`. Without a `direction` a current is forecast
/// for the worst coil.
struct ThermalForecast {
  static constexpr MethodInfo kMethod{"thermal.forecast",
                                      Role::kObserve,
                                      "How long a current or an effect can flow.",
                                      {ErrorCode::kNoSuchEffect, ErrorCode::kNoSuchPattern}};
  using Result = ForecastResult;

  std::optional<double> current_a{};
  std::optional<Direction> direction{};
  std::optional<EffectStart> start{};  // on the wire: `method` and `params`
  std::optional<EffectNumber> effect{};

  void describe(Fields& f) {
    f.optional("current_a", current_a, {.min = 0});
    f.optional("direction", direction);
    describe_planned(f, start);
    f.optional("effect", effect, kEffectNumber);
    if (!f.checks()) return;
    if ((current_a ? 1 : 0) + (start ? 1 : 0) + (effect ? 1 : 0) != 1) {
      const char* named = effect ? "effect" : start ? "method" : "current_a";
      f.fail(
          invalid_params(named, "give exactly one of current_a, method with params, and effect"));
    }
    if (direction && !current_a) f.fail(invalid_params("direction", "goes with current_a only"));
  }
  friend bool operator==(const ThermalForecast&, const ThermalForecast&) = default;
};

using ThermalMethods = TypeList<ThermalForecast>;

}  // namespace hedgehog::protocol
