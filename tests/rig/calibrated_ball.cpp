// SPDX-License-Identifier: MIT
#include "tests/rig/calibrated_ball.h"

#include "model/coils.h"
#include "model/identification/thermal_fit.h"
#include "tests/rig/heated_ball.h"

namespace hedgehog::rig {
namespace {

constexpr double kApartK = 2.0;
constexpr double kNoiseShare = 0.001;
constexpr double kResistanceUncertainty = 0.01;

}  // namespace

std::optional<ThermalBallOptions> calibrated(const ThermalBallOptions& drawn) {
  const device::FrontEndParameters built = drawn.board.front_end.parameters();
  model::RandomStream random(drawn.seed ^ 0x5eed);
  model::Readings readings;
  readings.current_gain = built.current_gain;
  readings.current_offset_a = built.current_offset_a;
  readings.supply_gain = built.supply_gain;
  readings.thermistor_offset_k = built.thermistor_offset_k[0];
  readings.current_noise_a = built.current_noise_a;

  ThermalBallOptions known = drawn;
  const double apart_k = random.uniform(-kApartK, kApartK);
  for (std::size_t i = 0; i < model::kCoils; ++i) {
    const double by_heat = model::kCopperPerKelvin * (apart_k - readings.thermistor_offset_k);
    known.coils.r25_ohm[i] = drawn.board.plant.r25_ohm[i] * readings.supply_gain /
                             readings.current_gain[i] *
                             (1.0 + by_heat + kNoiseShare * random.gaussian());
  }
  model::HeatedBall ball(drawn.board.plant, readings, drawn.board.ambient_c, random.bits());
  model::HeatRun run;
  run.began_at_rest = true;
  for (const model::HeatingStep& step : model::heating_plan())
    run.samples.push_back(ball.step(step));
  const auto found = model::fit_thermal({run}, known.coils.r25_ohm, model::ThermalModel{});
  if (!found) return std::nullopt;
  known.thermal = found->thermal;
  known.uncertainty = {found->uncertainty, kResistanceUncertainty, 0.5};
  return known;
}

}  // namespace hedgehog::rig
