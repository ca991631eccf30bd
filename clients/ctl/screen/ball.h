// SPDX-License-Identifier: MIT
// What a screen knows of the ball that it shows.
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

/// Where its pins are, as it describes them.
model::PinArray pin_array(const protocol::Description& description);

/// "pulse" of "effect.pulse"; a slot's name where there is one.
std::string effect_words(const protocol::EffectStatus& effect);

/// Of the hottest winding, which the thresholds belong to: "  temperature    41.2 °C  ━━━━──┊──
/// <behind>". `gauge_columns`: the width of the gauge.
std::string temperature_line(const Ball& ball, std::string_view behind, bool ascii,
                             int gauge_columns = kBarColumns);
/// Which winding that is, and the others: "               winding y  the hottest; x 40.8 °C, z
/// 38.4 °C"; empty while none is known.
std::string windings_line(const protocol::Status& status, bool ascii);
/// "  thermistor     38.3 °C  on winding z, 3 ms old".
std::string thermistor_line(const Ball& ball, bool ascii);
/// "winding y".
std::string hottest_winding(const protocol::Status& status);
/// "  current          5.0 A  ━━━━──────────  <behind>".
std::string current_line(const Ball& ball, std::string_view behind, bool ascii,
                         int gauge_columns = kBarColumns);

/// What may flow now: the limit by heat, and nothing while the ball is not armed.
double allowed_a(const protocol::Status& status);

/// "derates at 60, trips at 70" and "of 15.0 A allowed": what stands behind the two gauges.
std::string thresholds_words(const Ball& ball);
std::string allowed_words(const Ball& ball);

/// Length of the measured currents.
double current_norm_a(const protocol::Status& status);

}  // namespace hedgehog::client
