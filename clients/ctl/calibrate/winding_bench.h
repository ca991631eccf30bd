// SPDX-License-Identifier: MIT
// One winding at a time, driven through the public protocol and measured by telemetry.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/ctl/calibrate/winding_fit.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// Names of the three windings on screen, by index.
inline constexpr std::string_view kAxisNames = "xyz";

/// Telemetry of winding `coil` while it was driven.
struct WindingRecord {
  std::vector<WindingSample> samples;
  /// Mean currents of all three windings, A.
  std::array<double, 3> mean_a{};
  double supply_v = 0.0;
};

/// Blocking. Uses the telemetry of the connection exclusively; closing the connection switches the
/// coils off.
class WindingBench {
 public:
  explicit WindingBench(Session& session) : session_(session) {}

  /// The status of an armed ball with a working thermometer; otherwise an error.
  Outcome<protocol::Status> rest();
  /// Waits until `t_s` of device time without current.
  Outcome<void> wait_until(double t_s);
  /// How long a current is measured once it has settled: for `take_s`, and beyond it until the
  /// relative standard error of the measured quantity, the mean current or the inductance, is at
  /// most `max_error`, as long as the current flows.
  struct Extent {
    double take_s = 0.0;
    double max_error = std::numeric_limits<double>::infinity();
  };
  /// A constant current, `sign` * `current_a`.
  Outcome<WindingRecord> hold(int coil, double sign, double current_a, Extent extent);
  /// A sine between 0 and `current_a`.
  Outcome<WindingRecord> sine(int coil, double current_a, double frequency_hz, Extent extent);
  /// A push for a person to feel; replaces the previous one.
  Outcome<void> push(int coil, double current_a);
  /// Reason of a watchdog trip while a winding was measured.
  const std::optional<std::string>& tripped() const noexcept { return tripped_; }

 private:
  /// Relative standard error of the measured quantity.
  using ErrorOf = std::function<double(const std::vector<WindingSample>&)>;
  /// An error if too few samples were received until `flows_until_s`, of device time.
  Outcome<WindingRecord> record(int coil, Extent extent, const ErrorOf& error_of,
                                double flows_until_s);
  Outcome<void> play(model::EffectMethod method, const protocol::EffectParams& params);
  /// Starts the effect and the telemetry for `record`; returns until when the current flows at
  /// least, s of device time.
  Outcome<double> start(model::EffectMethod method, const protocol::EffectParams& params);
  Outcome<void> stop();
  /// The next status; an error if the ball is no longer armed, or on Ctrl-C.
  Outcome<protocol::Status> next();

  Session& session_;
  std::optional<std::string> tripped_;
};

}  // namespace hedgehog::client
