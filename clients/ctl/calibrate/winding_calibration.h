// SPDX-License-Identifier: MIT
// Resistance, inductance, sign and side of each winding of a ball at rest.
#pragma once

#include <string>

#include "clients/ctl/calibrate/calibrate_verb.h"
#include "clients/ctl/calibrate/calibration.h"

namespace hedgehog::client {

/// Blocking; uses the terminal for questions and output (text for users goes to stderr when stdout
/// is JSON). Returns the exit code, and `found` as far as measured.
int calibrate_windings(Session& session, const CalibrateOptions& options, PushedSides pushed,
                       const protocol::Description& before, Calibration& found);

/// Reports a calibration that cannot continue: `kEndedOtherwise`.
int print_error(const std::string& what);
/// The same for an error of the connection or the ball, and for Ctrl-C.
int give_up(const ClientError& error);

}  // namespace hedgehog::client
