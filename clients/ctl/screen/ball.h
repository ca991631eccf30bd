// SPDX-License-Identifier: MIT
// Data of the ball for a screen.
#pragma once

#include <string>
#include <string_view>

#include "clients/ctl/terminal/bar.h"
#include "model/geometry/pin_array.h"
#include "protocol/methods.h"
#include "protocol/values/description.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

struct Ball {
  protocol::HelloResult hello;
  protocol::Description description;
  protocol::Status status;
};

/// The pin positions in its description.
model::PinArray pin_array(const protocol::Description& description);

/// "pulse" of "effect.pulse"; the slot's name if there is one.
std::string effect_words(const protocol::EffectStatus& effect);

/// The hottest winding, to which the thresholds apply: "  temperature    41.2 °C  ━━━━──┊──
/// <behind>". `gauge_columns`: the width of the gauge.
std::string temperature_line(const Ball& ball, std::string_view behind, bool ascii,
                             int gauge_columns = kBarColumns);
/// The hottest winding, and the others: "               winding y  the hottest; x 40.8 °C, z 38.4
/// °C"; empty if no temperature is known.
std::string windings_line(const protocol::Status& status, bool ascii);
/// "  thermistor     38.3 °C  on winding z, 3 ms old".
std::string thermistor_line(const Ball& ball, bool ascii);
/// "winding y".
std::string hottest_winding(const protocol::Status& status);
/// "  current          5.0 A  ━━━━──────────  <behind>".
std::string current_line(const Ball& ball, std::string_view behind, bool ascii,
                         int gauge_columns = kBarColumns);

/// The present current limit: the thermal limit, 0 while the ball is not armed.
double allowed_a(const protocol::Status& status);

/// "derates at 60, trips at 70" and "of 15.0 A allowed": the texts to the right of the two gauges.
std::string thresholds_words(const Ball& ball);
std::string allowed_words(const Ball& ball);

/// Norm of the measured currents, A.
double current_norm_a(const protocol::Status& status);

}  // namespace hedgehog::client
