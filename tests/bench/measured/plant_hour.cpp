// SPDX-License-Identifier: MIT
// Processor time, s, of an hour of virtual time: plant, board, link and control; then the plant
// alone. `plant_hour TICKS`: computes TICKS milliseconds of it and scales.
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "model/thermal/plant.h"
#include "tests/rig/rig.h"

namespace {

using hedgehog::model::Tick;

constexpr Tick kHour = 3'600'000;
/// Effects along a winding as in a game: active a third of the time.
constexpr Tick kEvery = 450;
constexpr Tick kPulse = 150;

double hour_s(std::clock_t spent, Tick ticks) {
  return static_cast<double>(spent) / CLOCKS_PER_SEC * static_cast<double>(kHour) /
         static_cast<double>(ticks);
}

double loop_s(Tick ticks) {
  hedgehog::rig::Rig rig;
  rig.run_until_armed();
  const std::clock_t start = std::clock();
  for (Tick tick = 0; tick < ticks; ++tick) {
    if (tick % kEvery == 0) rig.start(hedgehog::rig::pulse({1, 2, 3}, 5.0, kPulse));
    if (tick % (100 * kEvery) == 0) rig.clear_events();
    rig.tick();
  }
  return hour_s(std::clock() - start, ticks);
}

double plant_s(Tick ticks) {
  hedgehog::model::Plant plant;
  hedgehog::model::PlantInputs inputs;
  inputs.bridge.fill(hedgehog::model::BridgeState::kDriven);
  inputs.fan_duty = 1.0;
  const std::clock_t start = std::clock();
  for (Tick tick = 0; tick < ticks; ++tick) {
    inputs.voltage_v = {tick % kEvery < kPulse ? 2.0 : 0.0, 0.5, 0.0};
    plant.step(inputs, hedgehog::model::kTickSeconds);
  }
  return hour_s(std::clock() - start, ticks);
}

}  // namespace

int main(int argc, char** argv) {
  const Tick ticks = argc == 2 ? std::atol(argv[1]) : 0;
  if (ticks < 1) {
    std::cerr << "plant_hour TICKS\n";
    return EXIT_FAILURE;
  }
  std::cout << loop_s(ticks) << '\n' << plant_s(ticks) << '\n';
}
