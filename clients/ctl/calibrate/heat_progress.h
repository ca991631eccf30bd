// SPDX-License-Identifier: MIT
// The file beside the output with the samples of a heating run, so that it can resume after an
// interruption: a JSON line that identifies the ball, then one for each sample.
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
  /// Windings as measured before the heating.
  Calibration windings;
  /// Name, board and resistances in force: identifies the ball and the device file measured.
  std::string ball;
  std::vector<model::HeatRun> runs;
  /// The first step of the plan that has not been measured.
  std::size_t next_step = 0;
};

/// Identifies the ball and the device file that the daemon uses.
std::string identity_of(const protocol::Description& ball);

/// Parses a progress file, whose last line may be truncated. nullopt: it is not a progress file.
std::optional<HeatProgress> read_progress(const std::string& text);

/// Why `progress` cannot resume with this ball, in the state `now`; "": it can. A ball more than 3
/// K cooler than at the start indicates another ambient temperature.
std::string incompatible(const HeatProgress& progress, const protocol::Description& ball,
                         const protocol::TemperatureStatus& now);

/// The first step of the interrupted phase.
std::size_t resumed_step(const std::vector<model::HeatingStep>& plan, std::size_t next_step);

/// Appends to the file, a line at a time; each is flushed to the operating system.
class HeatProgressFile {
 public:
  /// Starts a new file with `progress`, including its samples; `ok()` reports success.
  HeatProgressFile(std::string path, const HeatProgress& progress);

  bool ok() const { return file_.good(); }
  const std::string& path() const { return path_; }
  /// `step`: index in the plan.
  void add(const model::HeatSample& sample, bool began_at_rest, std::size_t run, std::size_t step);
  void remove();

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace hedgehog::client
