// SPDX-License-Identifier: MIT
#include "clients/ctl/forecast_arguments.h"
#include "cli/program.h"

#include <string>

namespace hedgehog::client {
namespace {

/// CLI11 alone would only report a failed conversion.
cli::Validator current() {
  return {[](const std::string& text) {
            return cli::number_of(text)
                       ? std::string()
                       : "'" + text +
                             "' is no current in ampere; a direction comes after it: "
                             "hedgehogctl forecast 15 left";
          },
          "AMPERE"};
}

}  // namespace

void add_forecast_arguments(const cli::CommandSpec& forecast, ForecastOptions& options) {
  forecast.add_option("current_a", options.current_a, "ampere").check(current()).show_default();
  forecast.add_option("direction", options.direction, "left, 34, 90,20 or 0,1,0.5");
}

}  // namespace hedgehog::client
