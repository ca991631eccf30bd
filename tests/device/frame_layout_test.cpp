// SPDX-License-Identifier: MIT
// Every field of every frame at its bytes, as in the tables of board-protocol.md: read from a frame
// whose bytes all differ, and written at the same places.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "daemon/device/board_core/frame.h"

namespace hedgehog::board {
namespace {

/// One byte more than a frame, which must not be written.
using Bytes = std::array<std::uint8_t, kFrameSize + 1>;
constexpr std::uint8_t kBehind = 0xA5;

/// CRC-32 of IEEE 802.3, bit by bit.
std::uint32_t crc_of(const Bytes& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (std::size_t i = 0; i < 60; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

std::uint32_t u32(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[at + i]} << (8 * i);
  return value;
}
std::int32_t i32(const Bytes& bytes, std::size_t at) {
  return static_cast<std::int32_t>(u32(bytes, at));
}
std::uint16_t u16(const Bytes& bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}
std::int16_t i16(const Bytes& bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16(bytes, at));
}

void seal(Bytes& bytes) {
  const std::uint32_t crc = crc_of(bytes);
  for (std::size_t i = 0; i < 4; ++i) bytes[60 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
}

/// A valid frame, none of whose bytes is zero or equal to another of its payload.
Bytes frame_of(unsigned type, std::uint8_t flags = 0) {
  Bytes bytes{};
  for (std::size_t i = 0; i < kFrameSize; ++i) bytes[i] = static_cast<std::uint8_t>(3 + 5 * i);
  bytes[0] = 0x48;
  bytes[1] = 1;
  bytes[2] = static_cast<std::uint8_t>(type);
  bytes[3] = flags;
  bytes[kFrameSize] = kBehind;
  seal(bytes);
  return bytes;
}

/// `read` with the bytes outside of `used` set to zero, as a sender leaves reserved ones.
Bytes without_reserved(Bytes read, const std::vector<std::array<std::size_t, 2>>& used) {
  Bytes kept = read;
  for (std::size_t i = 8; i < 60; ++i) kept[i] = 0;
  for (const auto& [first, last] : used)
    for (std::size_t i = first; i <= last; ++i) kept[i] = read[i];
  seal(kept);
  return kept;
}

template <class Values>
Bytes written(const Values& values) {
  Bytes bytes;
  bytes.fill(kBehind);
  write_frame(values, bytes.data());
  return bytes;
}

TEST(FrameLayout, OnlyTheTypesOfTheProtocolAreKnown) {
  const std::set<unsigned> known{0x01, 0x02, 0x03, 0x04, 0x7E, 0x7F, 0x81, 0xFE};
  for (unsigned type = 0; type < 256; ++type) {
    const Bytes frame = frame_of(type);
    FrameHeader header;
    const FrameError error = read_header(frame.data(), kFrameSize, header);
    if (!known.contains(type)) {
      EXPECT_EQ(error, FrameError::kType) << type;
      continue;
    }
    EXPECT_EQ(error, FrameError::kNone) << type;
    EXPECT_EQ(static_cast<unsigned>(header.type), type);
    EXPECT_EQ(header.sequence, u32(frame, 4));
  }
}

TEST(FrameLayout, SetPoint) {
  const Bytes frame = frame_of(0x01, 1);
  const SetPointFrame values = read_set_point(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_TRUE(values.enable);
  for (std::size_t k = 0; k < kWindings; ++k) {
    EXPECT_EQ(values.duty_q15[k], i16(frame, 8 + 2 * k));
    EXPECT_EQ(values.boost_q15[k], i16(frame, 16 + 2 * k));
  }
  EXPECT_EQ(values.fan, frame[14]);
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 14}, {16, 21}}));
}

TEST(FrameLayout, AFlagOfASetPointIsItsFirstBit) {
  for (unsigned flags = 0; flags < 256; ++flags) {
    const Bytes frame = frame_of(0x01, static_cast<std::uint8_t>(flags));
    EXPECT_EQ(read_set_point(frame.data()).enable, (flags & 1u) != 0) << flags;
  }
  EXPECT_EQ(written(SetPointFrame{})[3], 0);
}

TEST(FrameLayout, TheLowestDutyIsTheNegativeOfTheHighest) {
  Bytes frame = frame_of(0x01);
  frame[10] = 0x00;
  frame[11] = 0x80;
  EXPECT_EQ(read_set_point(frame.data()).duty_q15[1], -32767);
  frame[10] = 0x01;
  EXPECT_EQ(read_set_point(frame.data()).duty_q15[1], -32767);
}

TEST(FrameLayout, Arm) {
  const Bytes frame = frame_of(0x02);
  const ArmFrame values = read_arm(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.count, frame[8]);
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 8}}));
}

TEST(FrameLayout, Limits) {
  const Bytes frame = frame_of(0x03);
  const LimitsFrame values = read_limits(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.sensor_cc, i16(frame, 8));
  EXPECT_EQ(values.current_ma, u16(frame, 10));
  EXPECT_EQ(values.heat_permille, u16(frame, 12));
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 13}}));
}

TEST(FrameLayout, BootLoader) {
  const Bytes frame = frame_of(0x04);
  const BootLoaderFrame values = read_boot_loader(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.key, u32(frame, 8));
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 11}}));
}

TEST(FrameLayout, SimulatorError) {
  const Bytes frame = frame_of(0x7E);
  const SimulatorErrorFrame values = read_simulator_error(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.generation, frame[8]);
  EXPECT_EQ(values.count, frame[9]);
  EXPECT_EQ(values.index, frame[10]);
  EXPECT_EQ(values.kind, frame[11]);
  EXPECT_EQ(values.coil, frame[12]);
  EXPECT_EQ(values.value_millionths, i32(frame, 16));
  EXPECT_EQ(values.ramp_ms, u32(frame, 20));
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 12}, {16, 23}}));
}

TEST(FrameLayout, Simulator) {
  const Bytes frame = frame_of(0x7F);
  const SimulatorFrame values = read_simulator(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.ambient_cc, i16(frame, 8));
  EXPECT_EQ(values.faults, u16(frame, 10));
  EXPECT_EQ(values.coil, frame[12]);
  EXPECT_EQ(values.errors, frame[13]);
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 13}}));
}

TEST(FrameLayout, SimulatorTruth) {
  const Bytes frame = frame_of(0xFE);
  const SimulatorTruthFrame values = read_simulator_truth(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  for (std::size_t k = 0; k < kWindings; ++k) {
    EXPECT_EQ(values.winding_mc[k], i32(frame, 8 + 4 * k));
    EXPECT_EQ(values.current_ma[k], i32(frame, 32 + 4 * k));
  }
  EXPECT_EQ(values.core_mc, i32(frame, 20));
  EXPECT_EQ(values.skin_mc, i32(frame, 24));
  EXPECT_EQ(values.ambient_mc, i32(frame, 28));
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 43}}));
}

TEST(FrameLayout, Telemetry) {
  const Bytes frame = frame_of(0x81);
  const TelemetryFrame values = read_telemetry(frame.data());
  EXPECT_EQ(values.sequence, u32(frame, 4));
  EXPECT_EQ(values.received_sequence, u32(frame, 8));
  EXPECT_EQ(values.set_point_sequence, u32(frame, 12));
  EXPECT_EQ(values.board_ms, u32(frame, 16));
  for (std::size_t k = 0; k < kWindings; ++k) {
    EXPECT_EQ(values.current_ma[k], i16(frame, 20 + 2 * k));
    EXPECT_EQ(values.duty_q15[k], i16(frame, 26 + 2 * k));
  }
  EXPECT_EQ(values.supply_mv, u16(frame, 32));
  EXPECT_EQ(values.sensor_cc, i16(frame, 34));
  EXPECT_EQ(values.fan_rpm, u16(frame, 36));
  EXPECT_EQ(values.fan, frame[38]);
  EXPECT_EQ(values.mode, frame[39]);
  EXPECT_EQ(values.arm_count, frame[40]);
  EXPECT_EQ(values.sensor_conversions, frame[41]);
  EXPECT_EQ(values.faults, u16(frame, 42));
  EXPECT_EQ(values.set_point_age_ms, frame[44]);
  EXPECT_EQ(values.sensor_limit_cc, i16(frame, 46));
  EXPECT_EQ(values.current_limit_ma, u16(frame, 48));
  EXPECT_EQ(values.winding_heat_permille, u16(frame, 50));
  EXPECT_EQ(values.device_heat_permille, u16(frame, 52));
  EXPECT_EQ(values.refused, u16(frame, 54));
  EXPECT_EQ(values.supply_ma, u16(frame, 56));
  EXPECT_EQ(values.other_cc, i16(frame, 58));
  EXPECT_EQ(written(values), without_reserved(frame, {{8, 59}}));
}

TEST(FrameLayout, FlagsAndBitsOfTelemetry) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    Bytes frame = frame_of(0x81, static_cast<std::uint8_t>(byte));
    frame[45] = static_cast<std::uint8_t>(~byte);
    seal(frame);
    const unsigned bits = frame[45];
    const TelemetryFrame values = read_telemetry(frame.data());
    EXPECT_EQ(values.supply_switch_closed, (byte & 1u) != 0);
    EXPECT_EQ(values.bridges_awake, (byte >> 1 & 1u) != 0);
    EXPECT_EQ(values.currents_in_line, (byte >> 2 & 1u) != 0);
    EXPECT_EQ(values.minor, byte >> 4);
    EXPECT_EQ(values.currents_measured, bits & 7u);
    EXPECT_EQ(values.thermistors, bits >> 3 & 3u);
    EXPECT_EQ(values.supply_current_measured, (bits >> 5 & 1u) != 0);
    EXPECT_EQ(values.other_thermistor, bits >> 6);
    frame[3] &= 0xF7;  // reserved
    seal(frame);
    EXPECT_EQ(written(values), frame) << byte;
  }
}

TEST(FrameLayout, TheFieldsThatShareAByteKeepToTheirBits) {
  TelemetryFrame values;
  values.supply_switch_closed = false;
  values.minor = 0xFF;
  EXPECT_EQ(written(values)[3], 0xF0);
  values = TelemetryFrame{};
  values.currents_measured = 0xFF;
  EXPECT_EQ(written(values)[45], 0x07);
  values = TelemetryFrame{};
  values.thermistors = 0xFF;
  EXPECT_EQ(written(values)[45], 0x18);
  values = TelemetryFrame{};
  values.other_thermistor = 0xFF;
  EXPECT_EQ(written(values)[45], 0xC0);
}

}  // namespace
}  // namespace hedgehog::board
