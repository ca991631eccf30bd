// SPDX-License-Identifier: MIT
// Fan control: full duty with a winding above 40 C or a 30 s mean of |I| above 3 A, off below 35 C.
#pragma once

#include <cstdint>

namespace hedgehog::model {

/// Real-time safe, trivially copyable; control thread, or the thread of a preview.
class Fan {
 public:
  static constexpr double kOnAboveC = 40.0;
  static constexpr double kOffBelowC = 35.0;
  static constexpr double kOnAboveA = 3.0;
  static constexpr double kMeanS = 30.0;
  static constexpr std::uint8_t kFullDuty = 255;

  /// New state of a fan in state `running` at this hottest temperature and mean of |I|.
  static bool runs(bool running, double hottest_c, double mean_a) noexcept;

  /// Advances by `dt_s` with the hottest temperature (infinite: unknown) and |I|. Returns the duty
  /// to command, 0..255.
  std::uint8_t step(double hottest_c, double current_a, double dt_s) noexcept;
  double mean_a() const noexcept { return mean_a_; }

 private:
  double mean_a_ = 0.0;
  bool on_ = false;
};

}  // namespace hedgehog::model
