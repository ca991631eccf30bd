// SPDX-License-Identifier: MIT
// The heating run of `calibrate --thermal`, and the fit of its results.
#pragma once

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/heat_progress.h"
#include "clients/ctl/verbs/session.h"
#include "protocol/values/description.h"

namespace hedgehog::client {

/// Runs the remaining steps of the heating plan, half an hour of device time; every sample is added
/// to `file` and `progress` at once. Shows the progress: a bar on a terminal, otherwise a line per
/// phase, with --json a JSON line every ten seconds of device time. Returns the exit code.
int heat_and_cool(Session& session, const protocol::Description& ball, HeatProgressFile& file,
                  HeatProgress& progress);

/// Fits the thermal constants to `progress`, stores them in `found` and prints them. Returns the
/// exit code.
int fit_heat(const Session& session, const HeatProgress& progress,
             const protocol::Description& ball, Calibration& found);

}  // namespace hedgehog::client
