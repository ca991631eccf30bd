// SPDX-License-Identifier: MIT
// What a host makes of telemetry, by the board's version, and the limits that it sends to a board.
#include <gtest/gtest.h>

#include "daemon/device/board_codec.h"
#include "daemon/device/board_core/frame.h"

namespace hedgehog::device {
namespace {

BoardTelemetry decoded(const board::TelemetryFrame& values) {
  Frame frame;
  board::write_frame(values, frame.data());
  return decode_telemetry(frame).telemetry;
}

/// A frame of protocol 1.1 and later, with `other_cc` of its second thermistor.
board::TelemetryFrame with_validity(std::int16_t other_cc = 2000) {
  board::TelemetryFrame values;
  values.thermistors = 3;
  values.other_thermistor = 1;
  values.other_cc = other_cc;
  return values;
}

TEST(BoardLimits, AreTheBoardsOwnUnlessTheBallsAreTighter) {
  const BoardLimits own;
  model::Limits limits;
  limits.trip_c = 70.0;
  limits.current_a = 15.0;
  EXPECT_EQ(BoardLimits::of(limits).sensor_c, 75.0);
  EXPECT_DOUBLE_EQ(BoardLimits::of(limits).current_a, 16.5);
  limits.trip_c = 60.0;
  limits.current_a = 10.0;
  EXPECT_EQ(BoardLimits::of(limits).sensor_c, 65.0);
  EXPECT_DOUBLE_EQ(BoardLimits::of(limits).current_a, 11.0);
  limits.trip_c = 90.0;
  limits.current_a = 30.0;
  EXPECT_EQ(BoardLimits::of(limits).sensor_c, own.sensor_c);
  EXPECT_EQ(BoardLimits::of(limits).current_a, own.current_a);
}

TEST(BoardCodecMeaning, TheAccuracyIsThatOfTheSensors) {
  board::TelemetryFrame values = with_validity();
  values.currents_in_line = true;
  EXPECT_EQ(decoded(values).accuracy, model::kInLineAccuracy);
  values.currents_in_line = false;
  EXPECT_EQ(decoded(values).accuracy, model::kDriverCsAccuracy);
}

TEST(BoardCodecMeaning, ABrokenThermistorHasNoTemperature) {
  const BoardTelemetry open = decoded(with_validity(board::kOpenCc));
  EXPECT_EQ(open.thermistor[1].state, ThermistorState::kOpen);
  EXPECT_EQ(open.thermistor[1].celsius, 0.0);
  const BoardTelemetry shorted = decoded(with_validity(board::kShortCc));
  EXPECT_EQ(shorted.thermistor[1].state, ThermistorState::kShorted);
  EXPECT_EQ(shorted.thermistor[1].celsius, 0.0);
}

TEST(BoardCodecMeaning, ABoardOfTheFirstVersionMeasuresNoSupplyCurrent) {
  board::TelemetryFrame values;
  values.supply_current_measured = true;
  values.supply_ma = 2000;
  EXPECT_FALSE(decoded(values).supply_current_known);
  EXPECT_EQ(decoded(values).supply_current_a, 0.0);
  values = with_validity();
  values.supply_ma = 2000;
  EXPECT_FALSE(decoded(values).supply_current_known);
  EXPECT_EQ(decoded(values).supply_current_a, 0.0);
}

TEST(BoardCodecMeaning, ABoardOfTheFirstVersionMeasuresWhatItDrivesOrShows) {
  board::TelemetryFrame values;
  values.current_ma[0] = 500;
  values.current_ma[1] = 501;
  values.current_ma[2] = -501;
  EXPECT_EQ(decoded(values).measured, (Measured{false, true, true}));
  values.current_ma[1] = values.current_ma[2] = 0;
  values.duty_q15[2] = -1;
  EXPECT_EQ(decoded(values).measured, (Measured{false, false, true}));
}

TEST(BoardCodecMeaning, SimulatorSettingsAreOfAWindingThatExists) {
  SimulatorSettings settings;
  settings.coil = 200;
  EXPECT_EQ(decode_simulator(encode_simulator(settings, 1)).coil, 2);
}

TEST(BoardCodecMeaning, SimulatorSettingsNameTheNumberOfTheirErrors) {
  SimulatorSettings settings;
  settings.errors.count = 3;
  const Frame frame = encode_simulator(settings, 1);
  EXPECT_EQ(board::read_simulator(frame.data()).errors, 3);
}

TEST(BoardCodecMeaning, TheLimitsInForceAndTheFullerBudgetAreReported) {
  board::TelemetryFrame values = with_validity();
  values.sensor_limit_cc = 6500;
  values.current_limit_ma = 11'000;
  values.winding_heat_permille = 300;
  values.device_heat_permille = 400;
  const BoardTelemetry telemetry = decoded(values);
  EXPECT_EQ(telemetry.limit_sensor_c, 65.0);
  EXPECT_EQ(telemetry.limit_current_a, 11.0);
  EXPECT_EQ(telemetry.heat_used, 0.4);
}

TEST(BoardCodecMeaning, AFrameOfAnotherTypeIsNotRead) {
  const DecodedTelemetry other = decode_telemetry(encode_arm(1, 99));
  EXPECT_EQ(other.error, board::FrameError::kType);
  EXPECT_EQ(other.telemetry.sequence, 0u);
}

TEST(BoardCodecMeaning, OnlyAnotherThermistorOfTheBoardReplacesItsReading) {
  board::TelemetryFrame values = with_validity(5000);
  values.sensor_cc = 3000;
  values.other_thermistor = 0;
  EXPECT_EQ(decoded(values).thermistor[0].celsius, 30.0);
  values.other_thermistor = 3;
  for (const Thermistor& one : decoded(values).thermistor) EXPECT_NE(one.celsius, 50.0);
}

/// Error `index` of `count`, an offset of thermistor `coil`.
Frame error_frame(std::uint8_t generation, std::uint8_t count, std::uint8_t index,
                  std::uint8_t coil = 1, std::uint8_t kind = 6) {
  board::SimulatorErrorFrame values;
  values.generation = generation;
  values.count = count;
  values.index = index;
  values.coil = coil;
  values.kind = kind;
  values.value_millionths = 2'000'000;
  Frame frame;
  board::write_frame(values, frame.data());
  return frame;
}

TEST(SimulatorErrorReader, CompletesAListOnceAllItsErrorsHaveArrived) {
  SimulatorErrorReader reader;
  for (std::uint8_t index = 0; index < 31; ++index)
    ASSERT_FALSE(reader.take(error_frame(1, 32, index)).has_value());
  ASSERT_TRUE(reader.take(error_frame(1, 32, 31)).has_value());
  EXPECT_FALSE(reader.take(error_frame(1, 32, 31)).has_value()) << "once";
  EXPECT_FALSE(reader.take(error_frame(2, 2, 1)).has_value()) << "the first has not arrived";
  const auto next = reader.take(error_frame(2, 2, 0));
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->count, 2);
  EXPECT_EQ(next->error[0].value, 2.0);
  EXPECT_EQ(next->error[2].value, SimulatorErrorList{}.error[2].value) << "of the list before";
}

TEST(SimulatorErrorReader, IgnoresWhatCannotBe) {
  SimulatorErrorReader reader;
  EXPECT_FALSE(reader.take(error_frame(3, 1, 1)).has_value());
  EXPECT_TRUE(reader.take(error_frame(3, 1, 0)).has_value());
  EXPECT_FALSE(reader.take(error_frame(1, 0, 0)).has_value());
  EXPECT_FALSE(reader.take(error_frame(1, 33, 0)).has_value());
  EXPECT_FALSE(reader.take(error_frame(1, 1, 0, 1, kSimulatorErrorKinds)).has_value());
  const auto taken = reader.take(error_frame(1, 1, 0, 200));
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(taken->error[0].coil, 2);
}

TEST(PlantTruth, IsReadFromItsOwnFrameOnly) {
  PlantTruth truth;
  truth.coils_c = {31.0, 32.0, 33.0};
  truth.current_a = {1.0, -2.0, 3.0};
  truth.core_c = 34.0;
  truth.skin_c = 35.0;
  truth.ambient_c = 36.0;
  Frame frame = encode_truth(truth, 7);
  EXPECT_EQ(board::read_simulator_truth(frame.data()).sequence, 7u);
  const auto read = decode_truth(frame);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->coils_c, truth.coils_c);
  EXPECT_EQ(read->current_a, truth.current_a);
  EXPECT_EQ(read->core_c, 34.0);
  EXPECT_EQ(read->skin_c, 35.0);
  EXPECT_EQ(read->ambient_c, 36.0);
  EXPECT_FALSE(decode_truth(encode_arm(1, 1)).has_value());
  frame[10] ^= 1;
  EXPECT_FALSE(decode_truth(frame).has_value());
}

}  // namespace
}  // namespace hedgehog::device
