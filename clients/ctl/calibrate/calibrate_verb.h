// SPDX-License-Identifier: MIT
// `hedgehogctl calibrate`: measures the windings of a ball and writes its device file.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct CalibrateOptions {
  std::string out;
  /// Empty: the present name of the ball.
  std::string name;
  /// Maximum current through a winding, A; limited to 1.2 if its resistance in the device file in
  /// force is wrong.
  double current_a = 1.2;
  /// "x=front" and so on; empty: the user is asked if there is a terminal.
  std::vector<std::string> pushed;
  /// Replaces an existing file, and measures a ball that is not at one temperature.
  bool force = false;
  /// Also heats and cools the ball to identify its thermal constants.
  bool thermal = false;
};

int run_calibrate(Session& session, const CalibrateOptions& options);

}  // namespace hedgehog::client
