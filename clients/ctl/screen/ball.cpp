// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/ball.h"

#include <algorithm>
#include <array>

#include "clients/ctl/terminal/bar.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

// From a cool room to a little above the trip.
constexpr double kScaleLowC = 22.0;
constexpr double kScaleAboveTripC = 8.0;

}  // namespace

model::PinArray pin_array(const protocol::Description& description) {
  // More than the finest array has; a daemon may send anything.
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
  const protocol::LimitsDescription& limits = ball.description.limits;
  return "derates at " + fixed(limits.derate_from_c, 0) + ", trips at " + fixed(limits.trip_c, 0);
}

double allowed_a(const protocol::Status& status) {
  return status.state == "armed" ? status.limit_a : 0.0;
}

std::string allowed_words(const Ball& ball) {
  return "of " + fixed(allowed_a(ball.status), 1) + " A allowed";
}

double current_norm_a(const protocol::Status& status) { return norm(status.current_a); }

std::string temperature_line(const Ball& ball, std::string_view behind, bool ascii) {
  const auto& temperature = ball.status.temperature_c;
  const std::optional<double> shown = temperature.sensor ? temperature.sensor : temperature.model;
  const protocol::LimitsDescription& limits = ball.description.limits;
  const std::array marks{limits.derate_from_c, limits.trip_c};
  const double hottest =
      std::max(shown.value_or(kScaleLowC), temperature.model.value_or(kScaleLowC));
  const std::string value =
      shown ? fixed(*shown, 1) + (ascii ? " C" : " °C") : std::string("unknown");
  return row("temperature", value,
             bar(hottest, kScaleLowC, limits.trip_c + kScaleAboveTripC, marks, ascii) + "  " +
                 std::string(behind));
}

std::string current_line(const Ball& ball, std::string_view behind, bool ascii) {
  const double current = current_norm_a(ball.status);
  return row(
      "current", fixed(current, 1) + " A",
      bar(current, 0.0, ball.hello.limits.current_a, {}, ascii) + "  " + std::string(behind));
}

}  // namespace hedgehog::client
