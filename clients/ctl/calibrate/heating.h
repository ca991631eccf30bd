// SPDX-License-Identifier: MIT
// The heating run of `calibrate --thermal`, and what follows from it.
#pragma once

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/heat_progress.h"
#include "clients/ctl/verbs/session.h"
#include "protocol/values/description.h"

namespace hedgehog::client {

/// Drives what is left of the heating plan, half an hour of the ball's time; every sample goes into
/// `file` and `progress` at once. Shows how far it is: a bar on a terminal, a line a phase
/// otherwise, with --json a JSON line every ten seconds of the ball's. Returns the exit code.
int heat_and_cool(Session& session, const protocol::Description& ball, HeatProgressFile& file,
                  HeatProgress& progress);

/// The thermal constants by `progress` into `found`, shown to a person. Returns the exit code.
int fit_heat(const Session& session, const HeatProgress& progress,
             const protocol::Description& ball, Calibration& found);

}  // namespace hedgehog::client
