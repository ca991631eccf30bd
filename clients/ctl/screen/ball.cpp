// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/ball.h"

#include <algorithm>
#include <array>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

// Scale from a cool ambient to a little above the trip.
constexpr double kScaleLowC = 22.0;
constexpr double kScaleAboveTripC = 8.0;
constexpr std::string_view kWindings = "xyz";

std::size_t hottest_of(const protocol::TemperatureStatus& temperature) {
  const auto& coils = temperature.coils;
  return static_cast<std::size_t>(std::max_element(coils.begin(), coils.end()) - coils.begin());
}

std::string degrees(double celsius, bool ascii) {
  return fixed(celsius, 1) + (ascii ? " C" : " °C");
}

}  // namespace

model::PinArray pin_array(const protocol::Description& description) {
  // Above the finest array; guards against invalid descriptions.
  constexpr std::int64_t kMaxRing = 31;
  model::PinArray array{description.arrangement, {}, {}};
  for (const protocol::PinDescription& pin : description.pins) {
    const auto ring = static_cast<int>(std::clamp<std::int64_t>(pin.ring, 0, kMaxRing));
    while (array.ring_start.size() <= static_cast<std::size_t>(ring))
      array.ring_start.push_back(array.pins.size());
    array.pins.push_back(
        {static_cast<int>(array.pins.size()), ring, model::unit_or(pin.position, {0, 0, 1})});
  }
  array.ring_start.push_back(array.pins.size());
  return array;
}

std::string effect_words(const protocol::EffectStatus& effect) {
  if (effect.slot) return *effect.slot;
  const std::size_t dot = effect.method.find('.');
  return dot == std::string::npos ? effect.method : effect.method.substr(dot + 1);
}

std::string thresholds_words(const Ball& ball) {
  const model::Limits& limits = ball.description.limits;
  return "derates at " + fixed(limits.derate_from_c, 0) + ", trips at " + fixed(limits.trip_c, 0);
}

double allowed_a(const protocol::Status& status) {
  return status.state == "armed" ? status.limit_a : 0.0;
}

std::string allowed_words(const Ball& ball) {
  return "of " + fixed(allowed_a(ball.status), 1) + " A allowed";
}

double current_norm_a(const protocol::Status& status) { return norm(status.current_a); }

std::string hottest_winding(const protocol::Status& status) {
  return std::string("winding ") + kWindings[hottest_of(status.temperature_c)];
}

std::string temperature_line(const Ball& ball, std::string_view behind, bool ascii,
                             int gauge_columns) {
  const std::optional<double>& hottest = ball.status.temperature_c.model;
  const model::Limits& limits = ball.description.limits;
  const std::array marks{limits.derate_from_c, limits.trip_c};
  return row("temperature", hottest ? degrees(*hottest, ascii) : "unknown",
             bar(hottest.value_or(kScaleLowC), kScaleLowC, limits.trip_c + kScaleAboveTripC, marks,
                 ascii, gauge_columns) +
                 "  " + std::string(behind));
}

std::string windings_line(const protocol::Status& status, bool ascii) {
  const auto& temperature = status.temperature_c;
  if (!temperature.model) return {};
  const std::size_t hottest = hottest_of(temperature);
  std::string others;
  for (std::size_t i = 0; i < temperature.coils.size(); ++i) {
    if (i == hottest) continue;
    others += (others.empty() ? "" : ", ") + std::string(1, kWindings[i]) + " " +
              degrees(temperature.coils[i], ascii);
  }
  return row("", hottest_winding(status), "the hottest; " + others);
}

std::string thermistor_line(const Ball& ball, bool ascii) {
  const auto& temperature = ball.status.temperature_c;
  const auto winding = static_cast<std::size_t>(ball.description.thermal.sensor_winding);
  std::string behind = std::string("on winding ") + kWindings[winding];
  if (!temperature.age_ms)
    behind += ", never read";
  else if (temperature.sensor)
    behind += ", " + std::to_string(*temperature.age_ms) + " ms old";
  else
    behind += ", silent for " + time_words(static_cast<double>(*temperature.age_ms) / 1000.0);
  return row("thermistor", temperature.sensor ? degrees(*temperature.sensor, ascii) : "unknown",
             behind);
}

std::string current_line(const Ball& ball, std::string_view behind, bool ascii, int gauge_columns) {
  const double current = current_norm_a(ball.status);
  return row("current", fixed(current, 1) + " A",
             bar(current, 0.0, ball.hello.limits.current_a, {}, ascii, gauge_columns) + "  " +
                 std::string(behind));
}

}  // namespace hedgehog::client
