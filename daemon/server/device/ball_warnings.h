// SPDX-License-Identifier: MIT
// Warnings for the log about faults of the ball that do not stop it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "daemon/server/device/device_view.h"

namespace hedgehog::server {

/// io thread only.
class BallWarnings {
 public:
  static constexpr double kMaxDrift = 0.05;  // share of R25; a larger drift is reported

  /// The changes since the last call, as sentences.
  std::vector<std::string> step(const DeviceView& device_view);

 private:
  void step_fan(const DeviceView& device_view, std::vector<std::string>& sentences);
  void step_winding(int coil, const DeviceView& device_view, std::vector<std::string>& sentences);

  bool fan_works_ = true;
  std::array<bool, model::kCoils> seen_{};  // per winding: R25 of this run was checked
};

}  // namespace hedgehog::server
