// SPDX-License-Identifier: MIT
// `hedgehogctl pins --live`: the extension of each pin, in 80x22.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"

namespace hedgehog::client {

/// The unrolled ball with a number at each pin, then the most extended pins. Without
/// `ball.status.pins` from the daemon all pins are at rest.
std::vector<std::string> pins_screen(const Ball& ball, const ScreenStyle& style);

/// One line for a pipe: "  12.30 s    5.0 A   0.062 N   +0.077 mm at pin 34   25 out, 40 in".
std::string pins_line(const protocol::Status& status);

/// "0.062 N, 0.08 mm at pin 34", or "no force".
std::string aimed_pin_words(const protocol::Status& status);

}  // namespace hedgehog::client
