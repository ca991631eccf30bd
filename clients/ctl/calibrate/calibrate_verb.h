// SPDX-License-Identifier: MIT
// `hedgehogctl calibrate`: measures the windings of a ball and writes its device file.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct CalibrateOptions {
  std::string out;
  /// Empty: the name that the ball has.
  std::string name;
  /// The most that a winding is measured with, A; no more than 1.2 where the file in force does not
  /// know its resistance.
  double current_a = 1.2;
  /// "x=front" and so on; empty: a person is asked, when there is a terminal.
  std::vector<std::string> pushed;
  /// Replaces a file that is there, and measures a ball that is not at one temperature.
  bool force = false;
  /// Heats and cools the ball too, and finds its thermal constants.
  bool thermal = false;
};

int run_calibrate(Session& session, const CalibrateOptions& options);

}  // namespace hedgehog::client
