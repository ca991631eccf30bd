// SPDX-License-Identifier: MIT
// The steps of a heating plan, driven through the public protocol and measured by telemetry.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/verbs/session.h"
#include "model/identification/heat_record.h"
#include "model/identification/heating_plan.h"

namespace hedgehog::client {

/// A message every 7 ms. A mains supply's ripple has 100 or 120 Hz: at 100 Hz every message would
/// show the same moment of it, until a late one changes the moment and with it each resistance.
/// More messages also average more of the currents' noise.
inline constexpr double kHeatTelemetryHz = 1000.0 / 7.0;

/// One telemetry message of a step.
struct HeatReading {
  double t_s = 0.0;
  model::Vec3 voltage_v;
  model::Vec3 current_a;
};

/// The mean of `readings` since `from_s`: power over all of them, voltage and current over the last
/// ones, whose currents are settled. The caller sets sensor and fan. REQUIRES: not empty.
model::HeatSample mean_of(const std::vector<HeatReading>& readings, double from_s);

/// Blocking. Uses the telemetry of the connection exclusively; closing the connection switches the
/// coils off. All limits of the daemon stay in force: currents are measured, not assumed from the
/// request.
class HeatBench {
 public:
  /// `coils`: in force; the matrix is invertible.
  HeatBench(Session& session, const protocol::CoilsDescription& coils);

  /// Claims the ball and starts the telemetry.
  Outcome<void> begin();
  /// Runs one step; an error if the ball is no longer armed, telemetry ends, or on Ctrl-C.
  Outcome<model::HeatSample> run(const model::HeatingStep& step);
  Outcome<void> end();

 private:
  Outcome<void> drive(const model::HeatingStep& step);
  Outcome<protocol::Status> next();

  Session& session_;
  /// From winding currents to the field in the device frame.
  model::Mat3 to_demand_;
  /// Of the last telemetry, s of device time; negative: none yet.
  double now_s_ = -1.0;
};

}  // namespace hedgehog::client
