// SPDX-License-Identifier: MIT
// The ends of the port's ranges: what saturates, what counts as measured, which readings are a
// broken wire; and every reading of the NTC as recorded.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "daemon/device/board_core/port.h"

namespace hedgehog::board {
namespace {

/// A converter of 16 bits, so that thresholds are resolved.
Wiring fine(Wiring wiring = {}) {
  wiring.adc_full = 65535;
  return wiring;
}
std::uint16_t fine_adc(double mv) { return static_cast<std::uint16_t>(mv * 65535.0 / 3300.0); }

BoardOutputs driven_by(std::int16_t duty_q15) {
  BoardOutputs outputs;
  outputs.awake = true;
  outputs.duty_q15[0] = duty_q15;
  return outputs;
}

TEST(BoardPortRange, CurrentsSaturate) {
  Wiring wiring = fine(reference_wiring());
  wiring.current_uv_per_a[0] = wiring.current_uv_per_a[1] = 10'000;
  wiring.current_zero_uv[0] = 0;
  wiring.current_zero_uv[1] = 3'300'000;
  RawInputs raw;
  raw.current_adc[0] = 65535;
  const BoardInputs in = measured(wiring, raw, {});
  EXPECT_EQ(in.current_ma[0], INT16_MAX);
  EXPECT_EQ(in.current_ma[1], -INT16_MAX);
}

TEST(BoardPortRange, SaysHowCurrentsAreMeasured) {
  EXPECT_TRUE(measured(reference_wiring(), {}, {}).currents_in_line);
  EXPECT_FALSE(measured(Wiring{}, {}, {}).currents_in_line);
}

TEST(BoardPortRange, CsOfAnUndrivenBridgeCountsFromHalfAnAmpereOn) {
  const auto counts = [](double current_a, std::int16_t duty_q15) {
    RawInputs raw;
    raw.current_adc[0] = fine_adc(50.0 + 20.0 * current_a);
    return measured(fine(), raw, driven_by(duty_q15)).currents_measured == 1;
  };
  EXPECT_FALSE(counts(0.48, 0));
  EXPECT_TRUE(counts(0.52, 0));
  EXPECT_FALSE(counts(2.48, 1)) << "an on-time that is too short";
  EXPECT_TRUE(counts(2.52, 1));
}

TEST(BoardPortRange, ExtrapolatesByTheShareOfAMillisecond) {
  const Wiring wiring = fine(reference_wiring());
  RawInputs raw;
  raw.current_adc[0] = fine_adc(1650.0 + 50.0 * 14.0);
  const int shown_ma = measured(wiring, raw, {}).current_ma[0];
  BoardInputs last;
  for (std::int16_t& current : last.current_ma) current = -4000;
  EXPECT_EQ(measured(wiring, raw, {}, &last).current_ma[0],
            shown_ma + (shown_ma + 4000) * 100 / 900);
}

TEST(BoardPortRange, ADividerWithoutItsLowerResistorDividesByNothing) {
  Wiring wiring = fine();
  wiring.supply_lower_ohm = 0;
  wiring.supply_upper_ohm = 1;
  RawInputs raw;
  raw.supply_adc = fine_adc(1000.0);
  EXPECT_NEAR(measured(wiring, raw, {}).supply_mv, 1000, 1);
}

TEST(BoardPortRange, AThermistorWithinAHundredthOfARailIsABrokenWire) {
  const auto thermistor = [](std::uint16_t adc) {
    RawInputs raw;
    raw.ntc_adc[0] = adc;
    return measured(fine(), raw, {}).thermistor[0];
  };
  EXPECT_FALSE(thermistor(65535 - 655).open);
  EXPECT_TRUE(thermistor(65535 - 654).open);
  EXPECT_FALSE(thermistor(655).shorted);
  EXPECT_TRUE(thermistor(654).shorted);
}

TEST(BoardPortRange, ThermistorsThatAreNotWiredKeepTheirInitialValue) {
  RawInputs raw;
  raw.ntc_adc[1] = 1000;
  EXPECT_EQ(measured(Wiring{}, raw, {}).thermistor[1].cc, ThermistorInput{}.cc);
}

TEST(BoardPortRange, ATachPeriodOfHalfAMinuteIsATurnPerMinute) {
  RawInputs raw;
  raw.tach_period_us = 30'000'000;
  EXPECT_EQ(measured(Wiring{}, raw, {}).fan_rpm, 1);
  raw.tach_period_us = 30'000'001;
  EXPECT_EQ(measured(Wiring{}, raw, {}).fan_rpm, 0);
}

TEST(BoardPortRange, ABridgeThatBrakesHasTheForwardDirection) {
  const PinOutputs pins = pins_for(Wiring{}, driven_by(0));
  EXPECT_FALSE(pins.reverse[0]);
  EXPECT_EQ(pins.pwm[0], 0);
}

TEST(BoardPortRange, TheSupplySwitchFollowsTheRules) {
  for (const bool closed : {false, true}) {
    BoardOutputs outputs;
    outputs.supply_switch_closed = closed;
    EXPECT_EQ(pins_for(Wiring{}, outputs).supply_switch_closed, closed);
  }
}

TEST(BoardPortRange, ANtcOfLessThanAnOhmIsHot) {
  EXPECT_EQ(ntc_cc(1, 65535, 100), 12500);
  EXPECT_EQ(ntc_cc(0, 65535, 100), 12500);
}

/// Sum over every reading of a converter of 16 bits, weighted by the reading so that differences do
/// not cancel.
std::int64_t ntc_sum(std::uint16_t pull_up_ohm) {
  std::int64_t sum = 0;
  for (std::uint32_t adc = 0; adc < 65536; ++adc)
    sum += std::int64_t{ntc_cc(static_cast<std::uint16_t>(adc), 65535, pull_up_ohm)} * (adc + 1);
  return sum;
}

TEST(BoardPortRange, EachReadingOfTheNtcIsThatOfItsFormula) {
  for (std::uint32_t adc = 700; adc < 64'000; ++adc) {
    const double ohm = 10'000.0 * adc / (65535.0 - adc);
    const double exact_c = 1.0 / (1.0 / 298.15 + std::log(ohm / 10'000.0) / 3950.0) - 273.15;
    const double limit_k = exact_c >= 0.0 && exact_c <= 100.0 ? 0.2 : 0.6;
    if (exact_c < -40.0 || exact_c > 125.0) continue;
    ASSERT_NEAR(ntc_cc(static_cast<std::uint16_t>(adc), 65535, 10'000) / 100.0, exact_c, limit_k);
  }
}

// To the last digit, so that a changed entry of the table is noticed.
TEST(BoardPortRange, EachReadingOfTheNtcIsAsRecorded) {
  EXPECT_EQ(ntc_sum(10'000), 1'660'464'888'229);
  EXPECT_EQ(ntc_sum(2'200), 8'805'905'198'819);
  EXPECT_EQ(ntc_sum(47'000), -3'903'144'206'156);
}

}  // namespace
}  // namespace hedgehog::board
