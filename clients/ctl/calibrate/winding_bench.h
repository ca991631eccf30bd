// SPDX-License-Identifier: MIT
// One winding at a time, driven through the public protocol and measured by telemetry.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/ctl/calibrate/winding_fit.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

/// Names of the three windings on screen, by index.
inline constexpr std::string_view kAxisNames = "xyz";

/// What the daemon told of winding `coil` while it was driven.
struct WindingRecord {
  std::vector<WindingSample> samples;
  /// What all three carried on average, A.
  std::array<double, 3> mean_a{};
  double supply_v = 0.0;
};

/// Blocking. The connection's telemetry is its own; ending the connection switches the coils off.
class WindingBench {
 public:
  explicit WindingBench(Session& session) : session_(session) {}

  /// The status of an armed ball whose thermometer answers; an error when it is not so.
  Outcome<protocol::Status> rest();
  /// Nothing flows until `t_s` of device time.
  Outcome<void> wait_until(double t_s);
  /// A steady current, `sign` * `current_a`, measured once it has settled, for `take_s`.
  Outcome<WindingRecord> hold(int coil, double sign, double current_a, double take_s);
  /// A sine between 0 and `current_a`.
  Outcome<WindingRecord> sine(int coil, double current_a, double frequency_hz);
  /// A push for a person to feel; takes the place of the one before.
  Outcome<void> push(int coil, double current_a);
  /// Why the watchdog tripped while a winding was measured.
  const std::optional<std::string>& tripped() const noexcept { return tripped_; }

 private:
  /// An error when too little was told until `flows_until_s`, of device time.
  Outcome<WindingRecord> record(int coil, double take_s, double flows_until_s);
  Outcome<void> play(model::EffectMethod method, const protocol::EffectParams& params);
  /// With the telemetry that `record` wants; until when the current flows at least, s of device
  /// time.
  Outcome<double> start(model::EffectMethod method, const protocol::EffectParams& params);
  Outcome<void> stop();
  /// The next status; an error when the ball is not armed any more, or on Ctrl-C.
  Outcome<protocol::Status> next();

  Session& session_;
  std::optional<std::string> tripped_;
};

}  // namespace hedgehog::client
