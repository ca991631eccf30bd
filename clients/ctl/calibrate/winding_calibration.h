// SPDX-License-Identifier: MIT
// Resistance, inductance, sign and side of each winding of a ball at rest.
#pragma once

#include <string>

#include "clients/ctl/calibrate/calibrate_verb.h"
#include "clients/ctl/calibrate/calibration.h"

namespace hedgehog::client {

/// Blocking; asks and tells on the terminal (for people on stderr when stdout is a program's).
/// Returns the exit code, and `found` as far as it came.
int calibrate_windings(Session& session, const CalibrateOptions& options, PushedSides pushed,
                       const protocol::Description& before, Calibration& found);

/// Complains about a calibration that cannot go on: `kEndedOtherwise`.
int print_error(const std::string& what);
/// The same of an error of the connection or the ball, and of Ctrl-C.
int give_up(const ClientError& error);

}  // namespace hedgehog::client
