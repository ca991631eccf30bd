// SPDX-License-Identifier: MIT
// Frames byte by byte, as in README.md.
#include "daemon/device/board_codec.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>

#include "daemon/device/board_core/board_core.h"
#include "daemon/device/board_core/crc32.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

std::string hex(const Frame& frame) {
  static constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (i != 0 && i % 8 == 0) text += ' ';
    text += kDigits[frame[i] >> 4];
    text += kDigits[frame[i] & 15];
  }
  return text;
}

board::TelemetryFrame sample_telemetry() {
  board::TelemetryFrame values;
  values.sequence = 0x01020304;
  values.received_sequence = 0x11121314;
  values.set_point_sequence = 0x21222324;
  values.board_ms = 0x31323334;
  values.current_ma[0] = 15000;
  values.current_ma[1] = -1;
  values.current_ma[2] = -15000;
  values.duty_q15[0] = 32767;
  values.duty_q15[1] = -32767;
  values.duty_q15[2] = 16384;
  values.supply_mv = 12000;
  values.sensor_cc = -1050;
  values.fan_rpm = 7200;
  values.fan = 255;
  values.mode = 3;
  values.supply_switch_closed = false;
  values.bridges_awake = true;
  values.arm_count = 9;
  values.sensor_conversions = 200;
  values.faults = 0x0181;
  values.set_point_age_ms = 100;
  values.sensor_limit_cc = 7500;
  values.current_limit_ma = 16500;
  values.winding_heat_permille = 769;
  values.device_heat_permille = 500;
  values.refused = 3;
  return values;
}

TEST(Crc32, GivesTheCheckValueOfItsDefinition) {
  const std::string_view digits = "123456789";
  EXPECT_EQ(board::crc32(reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size()),
            0xCBF43926u);
}

TEST(Crc32, OfEachLengthUpToTwoSteps) {
  const std::string_view letters = "abcdefgh";
  const std::uint32_t expected[] = {0,           0xE8B7BE43u, 0x9E83486Du, 0x352441C2u, 0xED82CD11u,
                                    0x8587D865u, 0x4B8E39EFu, 0x312A6AA6u, 0xAEEF2A50u};
  for (std::size_t length = 0; length <= letters.size(); ++length)
    EXPECT_EQ(board::crc32(reinterpret_cast<const std::uint8_t*>(letters.data()), length),
              expected[length])
        << length;
}

TEST(GoldenFrame, SetPoint) {
  BoardCommand command =
      BoardCommand::drive(limited({5, 0, -3}), kColdOhm, 1.5e-3, {5, 0, -3}, 12.0);
  command.fan = 128;
  EXPECT_EQ(hex(encode_set_point(command, 0x01020304)),
            "4801010104030201 001800009af18000 0000000000000000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 00000000b0f193d8");
}

TEST(GoldenFrame, SetPointWithABoost) {
  BoardCommand command =
      BoardCommand::drive(limited({5, 0, -3}), kColdOhm, 1.5e-3, {4, 0, 12}, 12.0);
  command.fan = 128;
  EXPECT_EQ(hex(encode_set_point(command, 0x01020304)),
            "4801010104030201 001800009af18000 b80d0000678e0000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 00000000c8ae574d");
}

TEST(GoldenFrame, SafeSetPoint) {
  EXPECT_EQ(hex(encode_set_point(BoardCommand{}, 1)),
            "4801010001000000 0000000000000000 0000000000000000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 000000006cbbaab6");
}

TEST(GoldenFrame, Arm) {
  EXPECT_EQ(hex(encode_arm(7, 2)),
            "4801020002000000 0700000000000000 0000000000000000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 00000000c26d4b89");
}

TEST(GoldenFrame, Limits) {
  EXPECT_EQ(hex(encode_limits({60.0, 8.0, 0.5}, 3)),
            "4801030003000000 7017401ff4010000 0000000000000000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 000000002a0b08c6");
}

TEST(GoldenFrame, SimulatorSettings) {
  const SimulatorSettings settings{31.5, kSimStuckBridge | kSimSilent, 2, {}};
  EXPECT_EQ(hex(encode_simulator(settings, 4)),
            "48017f0004000000 4e0c400402000000 0000000000000000 0000000000000000 0000000000000000 "
            "0000000000000000 0000000000000000 00000000554c3e08");
}

TEST(GoldenFrame, Telemetry) {
  Frame frame;
  board::write_frame(sample_telemetry(), frame.data());
  EXPECT_EQ(hex(frame),
            "4801810204030201 1413121124232221 34333231983affff 68c5ff7f01800040 e02ee6fb201cff03 "
            "09c8810164004c1d 74400103f4010300 000000001ae7814b");
}

TEST(BoardCodec, DecodesTelemetryIntoUnits) {
  Frame frame;
  board::write_frame(sample_telemetry(), frame.data());
  const DecodedTelemetry decoded = decode_telemetry(frame);
  ASSERT_EQ(decoded.error, board::FrameError::kNone);
  const BoardTelemetry& telemetry = decoded.telemetry;
  EXPECT_EQ(telemetry.sequence, 0x01020304u);
  EXPECT_EQ(telemetry.received_sequence, 0x11121314u);
  EXPECT_EQ(telemetry.set_point_sequence, 0x21222324u);
  EXPECT_EQ(telemetry.board_ms, 0x31323334u);
  EXPECT_EQ(telemetry.current_a, (model::Vec3{15.0, -0.001, -15.0}));
  EXPECT_EQ(telemetry.duty.x, 1.0);
  EXPECT_EQ(telemetry.duty.y, -1.0);
  EXPECT_EQ(telemetry.supply_v, 12.0);
  EXPECT_EQ(telemetry.sensor_c, -10.5);
  EXPECT_EQ(telemetry.fan_rpm, 7200.0);
  EXPECT_EQ(telemetry.fan_duty, 1.0);
  EXPECT_EQ(telemetry.mode, BoardMode::kLatched);
  EXPECT_FALSE(telemetry.supply_switch_closed);
  EXPECT_TRUE(telemetry.bridges_awake);
  EXPECT_EQ(telemetry.arm_count, 9);
  EXPECT_EQ(telemetry.sensor_conversions, 200);
  EXPECT_EQ(telemetry.faults, board::kDeadMan | board::kStuckBridge | board::kSupply);
  EXPECT_EQ(telemetry.limit_sensor_c, 75.0);
  EXPECT_EQ(telemetry.limit_current_a, 16.5);
  EXPECT_EQ(telemetry.heat_used, 0.769);
}

// A board of protocol 1.0 sends nothing in byte 45: it measures a current only while it drives the
// winding.
TEST(BoardCodec, ABoardOfTheFirstVersionReportsTheFewestFields) {
  board::TelemetryFrame values;
  values.duty_q15[1] = -100;
  values.sensor_cc = 3000;
  Frame frame;
  board::write_frame(values, frame.data());
  const BoardTelemetry telemetry = decode_telemetry(frame).telemetry;
  EXPECT_EQ(telemetry.protocol_minor, 0);
  EXPECT_EQ(telemetry.measured, (Measured{false, true, false}));
  EXPECT_EQ(telemetry.thermistors, 1);
  EXPECT_EQ(thermistor_on(telemetry, 2).celsius, 30.0) << "the only one there is";
  EXPECT_FALSE(telemetry.supply_current_known);
}

TEST(BoardCodec, ABoardReportsWhatItMeasures) {
  board::TelemetryFrame values;
  values.currents_measured = 5;
  values.thermistors = 3;
  values.supply_current_measured = true;
  values.supply_ma = 60'000;
  values.sensor_cc = 3000;
  values.other_thermistor = 2;
  values.other_cc = -1050;
  Frame frame;
  board::write_frame(values, frame.data());
  EXPECT_EQ(frame[45], 0b10'1'11'101);
  BoardTelemetry telemetry = decode_telemetry(frame).telemetry;
  EXPECT_EQ(telemetry.protocol_minor, 1);
  EXPECT_EQ(telemetry.measured, (Measured{true, false, true}));
  EXPECT_EQ(telemetry.thermistors, 3);
  EXPECT_EQ(thermistor_on(telemetry, 0).celsius, 30.0);
  EXPECT_EQ(thermistor_on(telemetry, 1).state, ThermistorState::kNone) << "not yet its turn";
  EXPECT_EQ(thermistor_on(telemetry, 2).celsius, -10.5);
  EXPECT_TRUE(telemetry.supply_current_known);
  EXPECT_EQ(telemetry.supply_current_a, 60.0);
  values.other_cc = board::kOpenCc;
  board::write_frame(values, frame.data());
  telemetry = decode_telemetry(frame).telemetry;
  EXPECT_EQ(thermistor_on(telemetry, 2).state, ThermistorState::kOpen);
}

TEST(BoardCodec, ABoardReportsItsMinorVersionFrom12On) {
  board::TelemetryFrame values = sample_telemetry();
  values.minor = 2;
  Frame frame;
  board::write_frame(values, frame.data());
  EXPECT_EQ(frame[3], 0b0010'0010) << "beside the bridges' bit";
  EXPECT_EQ(board::read_telemetry(frame.data()).minor, 2);
  EXPECT_EQ(decode_telemetry(frame).telemetry.protocol_minor, 2);
  EXPECT_TRUE(decode_telemetry(frame).telemetry.bridges_awake);
  board::BoardCore core;
  core.write_telemetry(frame.data());
  EXPECT_EQ(decode_telemetry(frame).telemetry.protocol_minor, board::kProtocolMinor);
}

TEST(BoardCodec, AnUnknownModeDoesNotDrive) {
  board::TelemetryFrame values = sample_telemetry();
  values.mode = 4;
  Frame frame;
  board::write_frame(values, frame.data());
  EXPECT_EQ(decode_telemetry(frame).telemetry.mode, BoardMode::kLatched);
}

TEST(BoardCodec, FindsEverySingleByteCorruption) {
  Frame frame;
  board::write_frame(sample_telemetry(), frame.data());
  for (std::size_t at = 0; at < frame.size(); ++at) {
    for (unsigned change = 1; change < 256; ++change) {
      Frame broken = frame;
      broken[at] ^= static_cast<std::uint8_t>(change);
      ASSERT_NE(decode_telemetry(broken).error, board::FrameError::kNone) << at;
    }
  }
}

TEST(BoardCodec, ReportsWhyAFrameIsRefused) {
  Frame frame;
  board::write_frame(sample_telemetry(), frame.data());
  EXPECT_EQ(decode_telemetry(std::span(frame).first(63)).error, board::FrameError::kLength);
  EXPECT_EQ(decode_telemetry({}).error, board::FrameError::kLength);

  const auto with = [&](std::size_t at, std::uint8_t value) {
    Frame other = frame;
    other[at] = value;
    const std::uint32_t crc = board::crc32(other.data(), 60);
    for (std::size_t i = 0; i < 4; ++i) other[60 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    return other;
  };
  EXPECT_EQ(decode_telemetry(with(0, 0x49)).error, board::FrameError::kMagic);
  EXPECT_EQ(decode_telemetry(with(1, 2)).error, board::FrameError::kVersion);
  EXPECT_EQ(decode_telemetry(with(2, 0x33)).error, board::FrameError::kType);
  EXPECT_EQ(decode_telemetry(with(2, 0x01)).error, board::FrameError::kType);
  Frame broken = frame;
  broken[20] ^= 0x80;
  EXPECT_EQ(decode_telemetry(broken).error, board::FrameError::kCrc);
}

TEST(BoardCodec, AnInvalidLimitBecomesTheTightest) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Frame frame = encode_limits({nan, nan, nan}, 1);
  const board::LimitsFrame values = board::read_limits(frame.data());
  EXPECT_EQ(values.sensor_cc, INT16_MIN);
  EXPECT_EQ(values.current_ma, 0);
  EXPECT_EQ(values.heat_permille, 0);
}

RC_GTEST_PROP(BoardCodec, SimulatorSettingsAreDecodedUnchanged,
              (std::int16_t ambient_cc, std::uint16_t faults)) {
  SimulatorSettings settings;
  settings.ambient_c = ambient_cc / 100.0;
  settings.faults = faults;
  settings.coil = static_cast<std::uint8_t>(faults % 3);
  RC_ASSERT(decode_simulator(encode_simulator(settings, 1)) == settings);
}

}  // namespace
}  // namespace hedgehog::device
