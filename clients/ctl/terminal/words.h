// SPDX-License-Identifier: MIT
// Formatting of lines, times and tilts for users.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "clients/common/text.h"

namespace hedgehog::client {

/// A line of a screen: a name, its value at column 24, and a remark.
std::string row(std::string_view name, std::string_view value, std::string_view behind);

/// "3 d 4 h", "9 h 12 min", "3 min 20 s", "12 s", "1.5 s"; two parts at most.
std::string time_words(double seconds);
/// "for ever" for nullopt.
std::string headroom_words(std::optional<double> seconds);

/// A time of RFC 3339 as local time, in strftime's `format`; unchanged if it is invalid.
std::string local_time(const std::string& time, const char* format);

/// "tilted 12° left, 4° forward, heading 0°" of a ball with this `up` and heading; see
/// protocol::OrientationStatus.
std::string tilt_words(double up_x, double up_y, double up_z, double heading_deg);

}  // namespace hedgehog::client
