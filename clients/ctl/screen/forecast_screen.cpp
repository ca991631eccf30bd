// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/forecast_screen.h"

#include <optional>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

std::string forecast_words(std::optional<double> seconds) {
  return seconds ? "in " + time_words(*seconds) : "never";
}

}  // namespace

std::vector<std::string> forecast_screen(const protocol::ForecastResult& forecast, double current_a,
                                         const std::string& direction) {
  if (!forecast.temperature_known) {
    return {
        "The temperature of the ball is unknown: no current is allowed, no forecast is possible.",
        "Why, and what to do: hedgehogctl status"};
  }
  const bool full_now = forecast.recovery_s && *forecast.recovery_s <= 0.0;
  return {
      fixed(current_a, 1) + " A from now, " +
          (direction.empty() ? "on the coil that reaches its limit first" : direction) + ":",
      "  derated     " + forecast_words(forecast.seconds_to_derating),
      "  trips       " + forecast_words(forecast.seconds_to_limit) + ", if nothing were reduced",
      "  for ever    " + fixed(forecast.sustainable_a, 1) + " A",
      "  full again  " + (full_now ? "now" : forecast_words(forecast.recovery_s))};
}

}  // namespace hedgehog::client
