// SPDX-License-Identifier: MIT
// The winding currents that the next set-point's boost is computed from, against those of the
// plant.
#include "daemon/control/current_prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "daemon/control/drive.h"
#include "tests/device/limited.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

const model::Vec3 kX{1, 0, 0};
const model::Vec3 kY{0, 1, 0};

/// Minimum and maximum current of winding 0, in the direction of the first pulse, while a second
/// one plays that begins `gap` ticks after the end of one along that winding. `current_a` < 0: both
/// in the opposite direction.
struct Extremes {
  double min_a = 0.0;
  double max_a = 0.0;
};
Extremes of_second_pulse(const model::Vec3& second, double current_a, model::Tick gap,
                         double freewheel_v) {
  const double sign = std::copysign(1.0, current_a);
  rig::RigOptions options;
  options.board.front_end.kind = device::FrontEndKind::kIdeal;
  options.board.plant.freewheel_v = freewheel_v;
  rig::Rig rig(options);
  rig.run_until_armed();
  const EffectId first = rig.start(rig::pulse(sign * kX, std::abs(current_a), 60));
  rig.tick();
  rig.run_until([&] { return !rig.playing(first); }, 100);
  rig.run(gap);
  rig.start(rig::pulse(sign * second, std::abs(current_a), 60));
  Extremes found;
  for (int tick = 0; tick < 40; ++tick) {
    rig.tick();
    found.min_a = std::min(found.min_a, sign * rig.plant().current_a().x);
    if (tick > 2) found.max_a = std::max(found.max_a, sign * rig.plant().current_a().x);
  }
  return found;
}

// Minimum and maximum voltage that opposes a current while the bridges sleep: of a diode, and of
// the supply behind two.
constexpr double kDiodeV = 0.8;
constexpr double kSupplyV = 13.6;

TEST(CurrentPrediction, ACurrentThatHasEndedIsNotCounteracted) {
  for (const double current_a : {5.0, -12.0})
    for (model::Tick gap = 0; gap <= 25; ++gap)
      EXPECT_GT(of_second_pulse(kY, current_a, gap, kDiodeV).min_a, -0.1)
          << current_a << " A, " << gap << " ms after the pulse before";
}

TEST(CurrentPrediction, APulseAfterAnotherDoesNotOvershoot) {
  for (const double freewheel_v : {kDiodeV, kSupplyV})
    for (const double current_a : {5.0, -12.0})
      for (model::Tick gap = 0; gap <= 25; ++gap)
        EXPECT_LT(of_second_pulse(kX, current_a, gap, freewheel_v).max_a,
                  1.02 * std::abs(current_a))
            << current_a << " A, " << gap << " ms after the pulse before, " << freewheel_v << " V";
}

constexpr WindingCircuit kCircuit{{0.45, 0.5, 0.55}, 1.5e-3, 12.0};

device::BoardCommand driving(const model::Vec3& current_a) {
  return device::BoardCommand::drive(device::limited(current_a), kCircuit.resistance_ohm,
                                     kCircuit.inductance_h, {}, kCircuit.supply_v);
}
/// `from_a` after `ticks` at `volts`.
double after(double from_a, double volts, int coil, double ticks) {
  const double ohm = kCircuit.resistance_ohm[static_cast<std::size_t>(coil)];
  const double keep = std::exp(-ohm * ticks * model::kTickSeconds / kCircuit.inductance_h);
  return volts / ohm + keep * (from_a - volts / ohm);
}
void expect_near(const model::Vec3& found_a, const model::Vec3& wanted_a, int ticks) {
  for (int coil = 0; coil < model::kCoils; ++coil)
    EXPECT_NEAR(found_a[coil], wanted_a[coil], 1e-9) << coil << ", " << ticks << " ticks";
}

TEST(CurrentPrediction, ASetPointActsForATickWithItsBoost) {
  const device::BoardCommand command = driving({6, -5, 4});
  CurrentPrediction prediction;
  prediction.predict_currents(command, kCircuit);
  const model::Vec3 volts = kCircuit.supply_v * command.first_duty();
  model::Vec3 wanted_a;
  for (int coil = 0; coil < model::kCoils; ++coil)
    wanted_a[coil] = after(0.0, volts[coil], coil, 1);
  expect_near(prediction.a(), wanted_a, 1);
}

// The board then holds it without the boost for 19 ticks, and sleeps.
TEST(CurrentPrediction, SkippedTicksHoldTheSetPointUntilTheLinkSendsTheSafeCommand) {
  const device::BoardCommand command = driving({6, -5, 4});
  const model::Vec3 volts = kCircuit.supply_v * command.duty();
  for (const int skipped : {0, 1, 2, 18, 19, 20, 21, 24}) {
    CurrentPrediction prediction;
    prediction.predict_currents(command, kCircuit);
    model::Vec3 wanted_a = prediction.a();
    prediction.advance_skipped_ticks(skipped, command, kCircuit);
    const int held = std::min(skipped, 19);
    for (int coil = 0; coil < model::kCoils; ++coil) {
      wanted_a[coil] = after(wanted_a[coil], volts[coil], coil, held);
      const double opposed_v = std::copysign(kFreewheelV, -wanted_a[coil]);
      const double slept_a = after(wanted_a[coil], opposed_v, coil, skipped - held);
      wanted_a[coil] = slept_a * wanted_a[coil] > 0.0 ? slept_a : 0.0;
    }
    expect_near(prediction.a(), wanted_a, skipped);
  }
}

TEST(CurrentPrediction, ASleepingWindingLosesItsCurrentToTheDiodes) {
  CurrentPrediction prediction;
  prediction.predict_currents(driving({3, -2, 0}), kCircuit);
  const model::Vec3 from_a = prediction.a();
  const device::BoardCommand safe;
  for (int ticks = 1; ticks < 12; ++ticks) {
    CurrentPrediction skipped = prediction;
    skipped.advance_skipped_ticks(ticks, safe, kCircuit);
    model::Vec3 wanted_a;
    for (int coil = 0; coil < 2; ++coil) {
      const double a = after(from_a[coil], std::copysign(kFreewheelV, -from_a[coil]), coil, ticks);
      wanted_a[coil] = a * from_a[coil] > 0.0 ? a : 0.0;
    }
    expect_near(skipped.a(), wanted_a, ticks);
  }
  prediction.predict_currents(safe, kCircuit);
  EXPECT_NEAR(prediction.a().x, after(from_a.x, -kFreewheelV, 0, 1), 1e-9);
}

TEST(Drive, OfADemandTheShareThatWasPassedIsDelivered) {
  EXPECT_EQ(delivered_share({{0.0, 0.0, 0.0}}, {}), 1.0) << "nothing was requested";
  const model::LimitedCurrents passed = device::limited({0.3, 0.4, 0.0});
  EXPECT_NEAR(delivered_share({{0.6, 0.8, 0.0}}, passed), 0.5, 1e-12);
  EXPECT_NEAR(delivered_share({{3.0, 4.0, 0.0}}, passed), 0.1, 1e-12);
}

}  // namespace
}  // namespace hedgehog::control
