// SPDX-License-Identifier: MIT
// The simulated electronics' readings of the true values, converted by the firmware's own code.
#include "daemon/device/simulator/front_end.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hedgehog::device {
namespace {

struct Spread {
  double mean = 0.0;
  double sigma = 0.0;
};

/// A driven ball in steady state unless a test changes it.
struct Electronics {
  FrontEndChoice choice;
  FrontEnd front_end;
  Analogue analogue;
  board::BoardOutputs applied;

  explicit Electronics(FrontEndKind kind, std::uint64_t seed = 0)
      : choice{kind, 0, seed}, front_end(choice.parameters(), 7) {
    analogue.awake = applied.awake = true;
  }
  void drive(int coil, double duty, double current_a) {
    analogue.duty[coil] = duty;
    analogue.before_a[coil] = analogue.after_a[coil] = current_a;
    applied.duty_q15[coil] = static_cast<std::int16_t>(std::lround(32767.0 * duty));
  }
  board::BoardInputs read() {
    board::RawInputs raw;
    front_end.convert(analogue, raw);
    for (int k = 0; k < model::kCoils; ++k)
      raw.ntc_adc[k] = front_end.ntc_adc(front_end.thermistor_c(analogue, k));
    return board::measured(front_end.parameters().wiring, raw, applied);
  }
  bool measured(int coil) { return (read().currents_measured >> coil & 1) != 0; }
  /// Statistics of 2000 readings of one winding's current, A.
  Spread current_a(int coil) {
    constexpr int kReadings = 2000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kReadings; ++i) {
      const double a = read().current_ma[coil] / 1000.0;
      sum += a;
      squares += a * a;
    }
    const double mean = sum / kReadings;
    return {mean, std::sqrt(squares / kReadings - mean * mean)};
  }
};

TEST(FrontEnd, InLineMeasuresBothSignsInEveryBridgeState) {
  Electronics in_line(FrontEndKind::kInLine);
  in_line.drive(0, 0.5, 12.0);
  in_line.drive(1, 0.0, -3.0);  // decays in the brake
  EXPECT_EQ(in_line.read().currents_measured, 7);
  EXPECT_NEAR(in_line.current_a(0).mean, 12.0, 0.005);
  EXPECT_NEAR(in_line.current_a(1).mean, -3.0, 0.005);
  EXPECT_NEAR(in_line.current_a(0).sigma, 0.04, 0.006);
  in_line.applied.awake = in_line.analogue.awake = false;
  EXPECT_EQ(in_line.read().currents_measured, 7);
  EXPECT_NEAR(in_line.current_a(1).mean, -3.0, 0.005);
}

TEST(FrontEnd, DriverCsMeasuresOnlyWhileTheBridgeDrives) {
  Electronics cs(FrontEndKind::kDriverCs);
  cs.drive(0, -0.5, -12.0);
  cs.drive(1, 0.0, 3.0);   // braking
  cs.drive(2, 0.02, 0.5);  // too short
  EXPECT_NEAR(cs.current_a(0).mean, -12.0, 0.02);
  EXPECT_NEAR(cs.current_a(0).sigma, 0.10, 0.015);
  EXPECT_FALSE(cs.measured(1));
  EXPECT_FALSE(cs.measured(2));
  cs.drive(0, 0.5, -5.0);  // against the bridge
  EXPECT_FALSE(cs.measured(0));
  cs.analogue.awake = cs.applied.awake = false;
  EXPECT_EQ(cs.read().currents_measured, 0);
}

// The firmware drives nothing, but the PWM line is stuck.
TEST(FrontEnd, DriverCsMeasuresAnExternallyDrivenCurrent) {
  Electronics cs(FrontEndKind::kDriverCs);
  cs.drive(1, 0.3, 8.0);
  cs.applied.duty_q15[1] = 0;
  EXPECT_TRUE(cs.measured(1));
  EXPECT_NEAR(cs.current_a(1).mean, 8.0, 0.02);
}

TEST(FrontEnd, TheThreeCurrentsAreConvertedOneAfterTheOther) {
  Electronics in_line(FrontEndKind::kInLine);
  for (int coil = 0; coil < model::kCoils; ++coil) in_line.drive(coil, 0.5, 10.0);
  in_line.analogue.before_a = {};  // 10 A within the millisecond
  EXPECT_NEAR(in_line.current_a(0).mean, 10.0 - 1.0, 0.01);
  EXPECT_NEAR(in_line.current_a(1).mean, 10.0 - 0.5, 0.01);
  EXPECT_NEAR(in_line.current_a(2).mean, 10.0, 0.01);
}

TEST(FrontEnd, TheSupplyIsReadWithinABitAndWhatTheBridgesDraw) {
  for (const FrontEndKind kind : {FrontEndKind::kInLine, FrontEndKind::kDriverCs}) {
    Electronics electronics(kind);
    electronics.analogue.supply_v = 11.9;
    electronics.drive(0, 0.5, 12.0);
    electronics.drive(1, -0.2, -5.0);
    const board::BoardInputs in = electronics.read();
    EXPECT_NEAR(in.supply_mv, 11'900, 30);
    EXPECT_TRUE(in.supply_current_measured);
    EXPECT_NEAR(in.supply_ma, 7000, 120);
    // A current back into the supply is not shown.
    electronics.drive(0, -0.5, 12.0);
    EXPECT_NEAR(electronics.read().supply_ma, 0, 120);
  }
}

TEST(FrontEnd, ThermistorsAreReadWithinAQuarterOfAKelvin) {
  Electronics in_line(FrontEndKind::kInLine);
  for (const double celsius : {0.0, 25.0, 43.0, 70.0, 99.0}) {
    in_line.analogue.thermistor_c = {celsius, celsius, celsius};
    const board::BoardInputs in = in_line.read();
    ASSERT_EQ(in.thermistors, 3);
    for (const board::ThermistorInput& one : in.thermistor)
      EXPECT_NEAR(one.cc / 100.0, celsius, 0.25);
  }
}

TEST(FrontEnd, PartsAreDrawnFromTheirTolerancesBySeed) {
  const FrontEndParameters typical = FrontEndChoice{FrontEndKind::kInLine, 0, 0}.parameters();
  EXPECT_EQ(typical.current_gain[0], 1.0);
  EXPECT_EQ(typical.thermistor_offset_k[2], 0.0);
  double widest_gain = 0.0;
  double widest_offset_a = 0.0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const FrontEndParameters one = FrontEndChoice{FrontEndKind::kDriverCs, 3, seed}.parameters();
    EXPECT_EQ(one.wiring.thermistors, 3);
    EXPECT_EQ(one.current_gain,
              (FrontEndChoice{FrontEndKind::kDriverCs, 1, seed}.parameters().current_gain));
    for (std::size_t i = 0; i < model::kCoils; ++i) {
      widest_gain = std::max(widest_gain, std::abs(one.current_gain[i] - 1.0));
      widest_offset_a = std::max(widest_offset_a, std::abs(one.current_offset_a[i]));
      EXPECT_LE(std::abs(one.thermistor_offset_k[i]), 1.0);
    }
    EXPECT_LE(std::abs(one.supply_gain - 1.0), 0.02);
  }
  EXPECT_NEAR(widest_gain, 0.02, 0.001);
  EXPECT_NEAR(widest_offset_a, 0.1, 0.005);
}

TEST(FrontEnd, KindsHaveNames) {
  for (const auto* name : {"in_line", "driver_cs", "ideal"})
    EXPECT_EQ(device::name(*front_end_kind(name)), name);
  EXPECT_FALSE(front_end_kind("perfect"));
}

}  // namespace
}  // namespace hedgehog::device
