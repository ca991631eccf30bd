// SPDX-License-Identifier: MIT
// `hedgehogctl status`: the status of the ball, 80 columns.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "clients/ctl/screen/ball.h"

namespace hedgehog::client {

struct ScreenStyle {
  bool colour = false;
  bool ascii = false;
  /// Text that is too long for its column ends in an ellipsis; false: a pipe or a file, everything
  /// is printed.
  bool cuts = true;
  /// Width of a live picture, at least 80.
  std::size_t columns = 80;
};

/// "ball-7 · armed", green, amber or red if colours are enabled.
std::string state_words(const protocol::Status& status, const ScreenStyle& style);

/// "ball-7 · armed · 15.0 A allowed      SPACE stops   q quits": the first line of a live picture.
std::string live_title(const protocol::Status& status, const ScreenStyle& style);
/// The same when the rest of the picture may be outdated: `warning` gives the reason.
std::string warning_title(const std::string& warning, const ScreenStyle& style);

std::vector<std::string> status_screen(const Ball& ball, const ScreenStyle& style);

}  // namespace hedgehog::client
