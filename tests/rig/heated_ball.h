// SPDX-License-Identifier: MIT
// A simulated ball that is heated by the plan of `calibrate --thermal`, with the electronics'
// errors, in virtual time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/identification/heat_record.h"
#include "model/identification/heating_plan.h"
#include "model/random_stream.h"
#include "model/thermal/plant.h"

namespace hedgehog::model {

/// Measurement errors of one board. A ball's apparent constants include `power_gain(i)`.
struct Readings {
  std::array<double, 3> current_gain{1.0, 1.0, 1.0};
  std::array<double, 3> current_offset_a{};
  double supply_gain = 1.0;
  double thermistor_offset_k = 0.0;
  double current_noise_a = 0.04;

  double power_gain(std::size_t i) const { return current_gain[i] * supply_gain; }
};

class HeatedBall {
 public:
  HeatedBall(const PlantParameters& plant, const Readings& readings, double ambient_c,
             std::uint64_t seed)
      : plant_(plant, ambient_c), readings_(readings), noise_(seed) {}

  /// The measurements of one step of the plan; a step of less than half a second has not settled.
  HeatSample step(const HeatingStep& step) {
    constexpr double kTickS = 0.02;
    HeatSample sample;
    const int ticks = static_cast<int>(std::lround(step.duration_s / kTickS));
    double sensor_sum_c = 0.0;
    for (int tick = 0; tick < ticks; ++tick) {
      Vec3 squares;
      for (int coil = 0; coil < 3; ++coil)
        squares[coil] = step.current_a[coil] * step.current_a[coil];
      for (std::size_t i = 0; i < 3; ++i) {
        const double true_a = step.current_a[static_cast<int>(i)];
        const double volt =
            readings_.supply_gain * true_a * plant_.resistance_ohm(static_cast<int>(i));
        double shown_a = 0.0;
        if (true_a != 0.0) {
          shown_a = readings_.current_gain[i] * true_a + readings_.current_offset_a[i] +
                    0.5 * readings_.current_noise_a * noise_.gaussian();
        }
        sample.voltage_v[i] += volt / ticks;
        sample.current_a[i] += shown_a / ticks;
        sample.power_w[i] += volt * shown_a / ticks;
      }
      follow_fan(norm(step.current_a), kTickS);
      plant_.step_thermal(squares, fan_ ? 1.0 : 0.0, kTickS);
      sensor_sum_c += plant_.sensor_c() + readings_.thermistor_offset_k + 0.05 * noise_.gaussian();
      hottest_c_ = std::max(hottest_c_, plant_.hottest_winding_c());
    }
    now_s_ += step.duration_s;
    sample.dt_s = step.duration_s;
    sample.end_s = now_s_;
    sample.count = 4 * ticks;
    sample.fan_running = plant_.fan_rpm() > 300.0;
    sample.sensor_c = sensor_sum_c / ticks;
    return sample;
  }
  /// Cools without recording.
  void rest(double seconds) {
    for (double s = 0.0; s < seconds; s += 0.1) plant_.step_thermal({}, 0.0, 0.1);
    now_s_ += seconds;
  }

  double hottest_c() const { return hottest_c_; }

 private:
  /// The daemon's fan law, with an upper bound 2 K above the true temperature.
  void follow_fan(double current_a, double dt_s) {
    mean_a_ += (current_a - mean_a_) * dt_s / 30.0;
    const double upper_c = plant_.hottest_winding_c() + 2.0;
    if (mean_a_ > 3.0 || upper_c > 40.0)
      fan_ = true;
    else if (upper_c < 35.0)
      fan_ = false;
  }

  Plant plant_;
  Readings readings_;
  RandomStream noise_;
  bool fan_ = false;
  double mean_a_ = 0.0;
  double now_s_ = 0.0;
  double hottest_c_ = 0.0;
};

}  // namespace hedgehog::model
