// SPDX-License-Identifier: MIT
#include "daemon/server/device/ball_warnings.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "daemon/control/checks/fan_check.h"

namespace hedgehog::server {

std::vector<std::string> BallWarnings::step(const DeviceView& device_view) {
  std::vector<std::string> sentences;
  step_fan(device_view, sentences);
  for (int coil = 0; coil < model::kCoils; ++coil) step_winding(coil, device_view, sentences);
  return sentences;
}

void BallWarnings::step_fan(const DeviceView& device_view, std::vector<std::string>& sentences) {
  const control::StatusSnapshot& now = device_view.now();
  if (now.fan_works == fan_works_) return;
  fan_works_ = now.fan_works;
  if (fan_works_) {
    sentences.push_back(fmt::format("the fan turns at {:.0f}/min and is treated as working again",
                                    now.board.fan_rpm));
    return;
  }
  const double full_rpm = device_view.config().device.thermal.fan_full_rpm;
  sentences.push_back(fmt::format(
      "the fan's tachometer shows {:.0f}/min; a working fan of {:.0f}/min shows {:.0f} to {:.0f}: "
      "the fan is treated as stopped. Check the fan and its plug, and thermal.fan_rpm in the "
      "device file",
      now.board.fan_rpm, full_rpm, control::FanCheck::kMinCoolingShare * full_rpm,
      control::FanCheck::kMaxCoolingShare * full_rpm));
}

void BallWarnings::step_winding(int coil, const DeviceView& device_view,
                                std::vector<std::string>& sentences) {
  bool& seen = seen_[static_cast<std::size_t>(coil)];
  const auto r25 = device_view.r25(coil);
  if (!r25 || seen) {
    seen = r25.has_value();
    return;
  }
  seen = true;
  const auto moved = [&](double share, double ohm, const char* from) {
    sentences.push_back(fmt::format(
        "winding {}: R25 is {:.4f} ohm at this start, {:.1f} % {} than the {:.4f} ohm {}. Turns "
        "may "
        "be short, or a plug loose; if not, measure the ball anew: hedgehogctl calibrate",
        "xyz"[coil], r25 -> ohm, 100.0 * std::abs(share), share < 0.0 ? "less" : "more", ohm,
        from));
  };
  if (r25->from_kept && std::abs(*r25->from_kept) > kMaxDrift)
    moved(*r25->from_kept, *r25->kept_ohm, "of an earlier start");
  else if (std::abs(r25->from_file) > kMaxDrift)
    moved(r25->from_file, r25->file_ohm, "in the device file");
}

}  // namespace hedgehog::server
