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

/// One telemetry message of a step.
struct HeatReading {
  double t_s = 0.0;
  model::Vec3 voltage_v;
  model::Vec3 current_a;
};

/// The mean of `readings` since `from_s`: power over all of them, voltage and current over those at
/// the end whose currents no longer change. Sensor and fan are the caller's. REQUIRES: some.
model::HeatSample mean_of(const std::vector<HeatReading>& readings, double from_s);

/// Blocking. The connection's telemetry is its own; ending the connection switches the coils off.
/// All limits of the daemon stay in force: what flows is measured, whatever was asked for.
class HeatBench {
 public:
  /// `coils`: in force; the matrix can be inverted.
  HeatBench(Session& session, const protocol::CoilsDescription& coils);

  /// Claims the ball and starts the telemetry.
  Outcome<void> begin();
  /// One step; an error when the ball is not armed any more, telemetry ends, or on Ctrl-C.
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
