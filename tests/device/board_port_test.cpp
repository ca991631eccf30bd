// SPDX-License-Identifier: MIT
// From converters and timers to the inputs of the rules, and from their outputs to the pins.
#include "daemon/device/board_core/port.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <deque>
#include <vector>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

const Wiring kWiring;

std::uint16_t adc_of_mv(double mv) {
  return static_cast<std::uint16_t>(std::lround(mv * kWiring.adc_full / kWiring.adc_reference_mv));
}
/// The NTC by the formula of its data sheet.
std::uint16_t adc_of_ntc(double celsius) {
  const double ohm = 10'000.0 * std::exp(3950.0 * (1.0 / (celsius + 273.15) - 1.0 / 298.15));
  return static_cast<std::uint16_t>(
      std::lround(kWiring.adc_full * ohm / (ohm + kWiring.ntc_pull_up_ohm)));
}

BoardOutputs driven(std::int16_t x, std::int16_t y = 0, std::int16_t z = 0) {
  BoardOutputs outputs;
  outputs.awake = true;
  outputs.duty_q15[0] = x;
  outputs.duty_q15[1] = y;
  outputs.duty_q15[2] = z;
  return outputs;
}

TEST(BoardPort, TheNtcIsReadWithinAFifthOfAKelvinInTheWorkingRange) {
  for (int celsius = -40; celsius <= 125; ++celsius) {
    const double read = ntc_cc(adc_of_ntc(celsius), 4095, 10'000) / 100.0;
    EXPECT_NEAR(read, celsius, celsius >= 0 && celsius <= 100 ? 0.2 : 0.6) << celsius;
  }
  EXPECT_EQ(ntc_cc(0, 4095, 10'000), 12500);
  EXPECT_EQ(ntc_cc(4095, 4095, 10'000), -4000);
}

TEST(BoardPort, ABrokenWireIsNoTemperature) {
  RawInputs raw;
  raw.ntc_adc[0] = 4095;
  EXPECT_TRUE(measured(kWiring, raw, {}).thermistor[0].open);
  raw.ntc_adc[0] = 0;
  EXPECT_TRUE(measured(kWiring, raw, {}).thermistor[0].shorted);
  for (const double celsius : {-40.0, 25.0, 125.0}) {
    raw.ntc_adc[0] = adc_of_ntc(celsius);
    EXPECT_FALSE(measured(kWiring, raw, {}).thermistor[0].open) << celsius;
    EXPECT_FALSE(measured(kWiring, raw, {}).thermistor[0].shorted) << celsius;
  }
}

TEST(BoardPort, OnlyWiredThermistorsAreRead) {
  RawInputs raw;
  raw.ntc_adc[0] = adc_of_ntc(30.0);
  raw.ntc_adc[1] = adc_of_ntc(50.0);
  raw.ntc_adc[2] = 0;
  const BoardInputs one = measured(kWiring, raw, {});
  EXPECT_EQ(one.thermistors, 1);
  EXPECT_NEAR(one.thermistor[0].cc, 3000, 20);
  EXPECT_FALSE(one.thermistor[2].shorted) << "there is none";
  const BoardInputs three = measured(reference_wiring(), raw, {});
  EXPECT_EQ(three.thermistors, 3);
  EXPECT_NEAR(three.thermistor[1].cc, 5000, 20);
  EXPECT_TRUE(three.thermistor[2].shorted);
}

TEST(BoardPort, CsHasTheSignOfItsBridgeAndMeasuresNothingWhileItSleeps) {
  RawInputs raw;
  for (auto& adc : raw.current_adc) adc = adc_of_mv(50 + 15 * 20);  // zero, 15 A
  const BoardInputs in = measured(kWiring, raw, driven(8000, -8000, 8000));
  EXPECT_NEAR(in.current_ma[0], 15'000, 20);
  EXPECT_NEAR(in.current_ma[1], -15'000, 20);
  EXPECT_EQ(in.currents_measured, 7);
  BoardOutputs asleep = driven(8000);
  asleep.awake = false;
  EXPECT_EQ(measured(kWiring, raw, asleep).current_ma[0], 0);
  EXPECT_EQ(measured(kWiring, raw, asleep).currents_measured, 0);
}

// Protocol 1.0 discarded any current in a winding that was not driven.
TEST(BoardPort, CsOfABridgeThatIsNotDrivenCountsOnlyWhenItShowsACurrent) {
  RawInputs raw;
  for (auto& adc : raw.current_adc) adc = adc_of_mv(50);
  EXPECT_EQ(measured(kWiring, raw, driven(0, 0, 0)).currents_measured, 0) << "braking";
  raw.current_adc[1] = adc_of_mv(50 + 2.7 * 20);  // a PWM line that is stuck at 10 %
  const BoardInputs in = measured(kWiring, raw, driven(0, 0, 0));
  EXPECT_EQ(in.currents_measured, 2);
  EXPECT_NEAR(in.current_ma[1], 2700, 40);
}

TEST(BoardPort, CsMeasuresNothingInAnOnTimeTooShortForIt) {
  RawInputs raw;
  for (auto& adc : raw.current_adc) adc = adc_of_mv(50 + 20);  // 1 A
  const auto shortly = static_cast<std::int16_t>(kMinSampledDutyQ15 - 1);
  EXPECT_EQ(measured(kWiring, raw, driven(shortly, -shortly, kMinSampledDutyQ15)).currents_measured,
            4);
  raw.current_adc[0] = adc_of_mv(50 + 3 * 20);
  EXPECT_EQ(measured(kWiring, raw, driven(shortly, -shortly, 0)).currents_measured & 1, 1)
      << "more than that duty can drive";
}

TEST(BoardPort, CsBelowItsZeroIsACurrentAgainstTheBridgeAndNotMeasured) {
  RawInputs raw;
  raw.current_adc[0] = adc_of_mv(50 - 0.3 * 20);
  raw.current_adc[1] = adc_of_mv(50 - 0.1 * 20);
  const BoardInputs in = measured(kWiring, raw, driven(8000, 8000));
  EXPECT_EQ(in.currents_measured & 3, 2);
  EXPECT_EQ(in.current_ma[1], 0) << "a little below is the scatter of the zero";
}

TEST(BoardPort, AnAmplifierInTheLeadMeasuresBothSignsAlways) {
  const Wiring wiring = reference_wiring();
  RawInputs raw;
  raw.current_adc[0] = adc_of_mv(1650 + 15 * 50);
  raw.current_adc[1] = adc_of_mv(1650 - 15 * 50);
  raw.current_adc[2] = adc_of_mv(1650);
  for (const BoardOutputs& outputs : {BoardOutputs{}, driven(0), driven(-8000, 8000, 1)}) {
    const BoardInputs in = measured(wiring, raw, outputs);
    EXPECT_NEAR(in.current_ma[0], 15'000, 17);
    EXPECT_NEAR(in.current_ma[1], -15'000, 17);
    EXPECT_NEAR(in.current_ma[2], 0, 17);
    EXPECT_EQ(in.currents_measured, 7);
  }
}

TEST(BoardPort, EachWindingHasItsOwnScaleAndZero) {
  Wiring wiring = reference_wiring();
  RawInputs raw;
  for (int k = 0; k < kWindings; ++k) {
    wiring.current_uv_per_a[k] = static_cast<std::uint32_t>(49'100 + 900 * k);
    wiring.current_zero_uv[k] = 1'645'000 + 5'000 * k;
    raw.current_adc[k] = adc_of_mv(1645 + 5 * k + 12 * (49.1 + 0.9 * k));
  }
  for (const auto ma : measured(wiring, raw, {}).current_ma) EXPECT_NEAR(ma, 12'000, 17);
}

// Currents converted 100 and 50 us before the third are extrapolated to its conversion.
TEST(BoardPort, CurrentsAreExtrapolatedToTheLastConversion) {
  const Wiring wiring = reference_wiring();
  BoardInputs last;
  RawInputs raw;
  // From 2 A: rising by 10 A a millisecond, falling by as much, constant.
  raw.current_adc[0] = adc_of_mv(1650 + 50 * (2.0 + 9.0));
  raw.current_adc[1] = adc_of_mv(1650 + 50 * (2.0 - 9.5));
  raw.current_adc[2] = adc_of_mv(1650 + 50 * 2.0);
  for (std::int16_t& current : last.current_ma) current = 2000;
  const BoardInputs in = measured(wiring, raw, driven(8000), &last);
  EXPECT_NEAR(in.current_ma[0], 12'000, 20);
  EXPECT_NEAR(in.current_ma[1], -8000, 20);
  EXPECT_NEAR(in.current_ma[2], 2000, 20);
  last.currents_measured = 0;
  EXPECT_NEAR(measured(wiring, raw, driven(8000), &last).current_ma[0], 11'000, 20);
}

TEST(BoardPort, AShuntMeasuresWhatTheBridgesDraw) {
  RawInputs raw;
  raw.shunt_adc = adc_of_mv(200);
  const BoardInputs in = measured(reference_wiring(), raw, {});
  EXPECT_TRUE(in.supply_current_measured);
  EXPECT_NEAR(in.supply_ma, 2000, 10);
  EXPECT_FALSE(measured(kWiring, raw, {}).supply_current_measured) << "there is none";
  EXPECT_EQ(measured(kWiring, raw, {}).supply_ma, 0);
}

TEST(BoardPort, SupplyTachAndFaults) {
  RawInputs raw;
  raw.supply_adc = adc_of_mv(12'000.0 / 11.0);
  raw.tach_period_us = 4167;
  raw.faults_low = 0xFA;
  const BoardInputs in = measured(kWiring, raw, {});
  EXPECT_NEAR(in.supply_mv, 12'000, 12);
  EXPECT_EQ(in.fan_rpm, 7199);
  EXPECT_EQ(in.bridge_faults, 2);
  raw.tach_period_us = 0;
  EXPECT_EQ(measured(kWiring, raw, {}).fan_rpm, 0);
  raw.tach_period_us = 1;
  raw.supply_adc = 4095;
  EXPECT_EQ(measured(kWiring, raw, {}).fan_rpm, 65535) << "clamped";
  EXPECT_GT(measured(kWiring, raw, {}).supply_mv, 30'000);
}

TEST(BoardPort, PinsFollowTheDuties) {
  const PinOutputs pins = pins_for(kWiring, driven(INT16_MAX, -INT16_MAX / 2, INT16_MIN));
  EXPECT_TRUE(pins.awake);
  EXPECT_EQ(pins.pwm[0], kWiring.pwm_top);
  EXPECT_FALSE(pins.reverse[0]);
  EXPECT_NEAR(pins.pwm[1], kWiring.pwm_top / 2.0, 1);
  EXPECT_TRUE(pins.reverse[1]);
  EXPECT_EQ(pins.pwm[2], kWiring.pwm_top);
}

TEST(BoardPort, AsleepNothingIsDrivenForAnyDuty) {
  BoardOutputs outputs = driven(8000, -8000, 1);
  outputs.awake = false;
  const PinOutputs pins = pins_for(kWiring, outputs);
  EXPECT_FALSE(pins.awake);
  for (const auto pwm : pins.pwm) EXPECT_EQ(pwm, 0);
  EXPECT_EQ(safe_pins(kWiring).fan_pwm, kWiring.fan_top);
  EXPECT_FALSE(safe_pins(kWiring).awake);
}

TEST(BoardPort, NoDividerAndNoConverterOverflows) {
  Wiring wiring;
  wiring.supply_upper_ohm = 65535;
  wiring.supply_lower_ohm = 6553;
  RawInputs raw;
  raw.supply_adc = wiring.adc_full;
  EXPECT_NEAR(measured(wiring, raw, {}).supply_mv, 36'300, 10);
  wiring.adc_full = 65535;
  wiring.adc_reference_mv = 5000;
  raw.supply_adc = 65535;
  EXPECT_NEAR(measured(wiring, raw, {}).supply_mv, 55'000, 10);
}

RC_GTEST_PROP(BoardPortLaws, AnyNumbersStayInRange, ()) {
  RawInputs raw;
  for (auto& adc : raw.current_adc) adc = *rc::gen::arbitrary<std::uint16_t>();
  raw.supply_adc = *rc::gen::arbitrary<std::uint16_t>();
  for (auto& adc : raw.ntc_adc) adc = *rc::gen::arbitrary<std::uint16_t>();
  raw.shunt_adc = *rc::gen::arbitrary<std::uint16_t>();
  raw.tach_period_us = *rc::gen::arbitrary<std::uint32_t>();
  const auto duty = *rc::gen::arbitrary<std::int16_t>();
  const BoardInputs in = measured(kWiring, raw, driven(duty, duty, duty));
  for (const Wiring& wiring : {kWiring, reference_wiring()})
    for (const ThermistorInput& one : measured(wiring, raw, driven(duty)).thermistor)
      RC_ASSERT(one.cc >= -4000 && one.cc <= 12500);
  const PinOutputs pins = pins_for(kWiring, driven(duty, duty, duty));
  RC_ASSERT(pins.pwm[0] <= kWiring.pwm_top);
  RC_ASSERT((in.current_ma[0] == 0) || ((in.current_ma[0] < 0) == pins.reverse[0]));
}

/// A simulated microcontroller.
struct FakeMicrocontroller {
  std::deque<std::vector<std::uint8_t>> packets;
  RawInputs raw;
  PinOutputs pins;
  std::vector<std::uint8_t> sent;

  std::size_t receive(std::uint8_t* packet, std::size_t capacity) {
    if (packets.empty()) return 0;
    const auto next = packets.front();
    packets.pop_front();
    const std::size_t length = std::min(next.size(), capacity);
    std::copy_n(next.begin(), length, packet);
    return length;
  }
  void measure(RawInputs& values) { values = raw; }
  void apply(const PinOutputs& values) { pins = values; }
  void send(const std::uint8_t* frame) { sent.assign(frame, frame + kFrameSize); }
};

// Set-points and an arm request in, PWM out; then a frame that is too long, and then silence.
TEST(BoardMillisecond, DrivesThePinsAndMakesThemSafeInSilence) {
  BoardCore core;
  FakeMicrocontroller board;
  board.raw.supply_adc = adc_of_mv(12'000.0 / 11.0);
  board.raw.ntc_adc[0] = adc_of_ntc(30.0);
  board.raw.ntc_converted = true;
  for (auto& adc : board.raw.current_adc) adc = adc_of_mv(50);
  std::uint32_t sequence = 0;
  const auto queue = [&](auto values) {
    std::vector<std::uint8_t> frame(kFrameSize);
    values.sequence = ++sequence;
    write_frame(values, frame.data());
    board.packets.push_back(frame);
  };
  SetPointFrame set_point;
  set_point.enable = true;
  set_point.duty_q15[1] = -16384;
  ArmFrame arm;
  arm.count = 1;
  queue(set_point);
  queue(arm);
  board_millisecond(core, kWiring, board);
  EXPECT_FALSE(board.pins.awake) << "armed, and now a set-point is awaited";
  board.packets.emplace_back(kFrameSize + 10, 0x48);
  queue(set_point);
  board_millisecond(core, kWiring, board);
  EXPECT_TRUE(board.pins.awake);
  EXPECT_NEAR(board.pins.pwm[1], kWiring.pwm_top / 2.0, 1);
  EXPECT_TRUE(board.pins.reverse[1]);
  EXPECT_EQ(read_telemetry(board.sent.data()).refused, 1);
  EXPECT_NEAR(read_telemetry(board.sent.data()).sensor_cc, 3000, 20);
  for (int ms = 0; ms < 100; ++ms) board_millisecond(core, kWiring, board);
  EXPECT_FALSE(board.pins.awake);
  EXPECT_EQ(board.pins.pwm[1], 0);
  EXPECT_EQ(board.pins.fan_pwm, kWiring.fan_top);
}

}  // namespace
}  // namespace hedgehog::board
