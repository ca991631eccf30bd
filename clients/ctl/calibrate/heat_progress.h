// SPDX-License-Identifier: MIT
// The file beside the output that keeps what a heating run has measured, so that it can go on after
// an interruption: a JSON line that says which ball, then one for each sample.
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/calibrate/calibration.h"
#include "model/identification/heat_record.h"
#include "model/identification/heating_plan.h"
#include "protocol/values/description.h"
#include "protocol/values/status.h"

namespace hedgehog::client {

struct HeatProgress {
  /// What was measured of the windings before the heating.
  Calibration windings;
  /// Name, board and resistances in force: the ball and the file that all of it belongs to.
  std::string ball;
  std::vector<model::HeatRun> runs;
  /// The first step of the plan that has not been measured.
  std::size_t next_step = 0;
};

/// What identifies the ball and the device file that the daemon believes.
std::string identity_of(const protocol::Description& ball);

/// The text of a progress file; its last line may have been cut off. nullopt: it is none.
std::optional<HeatProgress> read_progress(const std::string& text);

/// Why `progress` cannot go on with this ball, in the state `now`; "": it can. A room that is
/// cooler by more than 3 K than the ball was at the start is another room.
std::string incompatible(const HeatProgress& progress, const protocol::Description& ball,
                         const protocol::TemperatureStatus& now);

/// The step with which the interrupted phase begins.
std::size_t resumed_step(const std::vector<model::HeatingStep>& plan, std::size_t next_step);

/// Appends to the file, a line at a time; each is on disk when it is written.
class HeatProgressFile {
 public:
  /// Begins anew with `progress`, its samples included; `ok()` says whether that worked.
  HeatProgressFile(std::string path, const HeatProgress& progress);

  bool ok() const { return file_.good(); }
  const std::string& path() const { return path_; }
  /// `step`: of the plan.
  void add(const model::HeatSample& sample, bool began_at_rest, std::size_t run, std::size_t step);
  void remove();

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace hedgehog::client
