// SPDX-License-Identifier: MIT
// Xsens messages: captures published in public repositories, with their decoded values (reference:
// hardware.md section 4.3), and properties.
#include "daemon/device/imu/xbus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "daemon/device/imu/mtdata2.h"
#include "tests/device/hex.h"
#include "tests/device/imu/mti_capture.h"

namespace hedgehog::device {
namespace {

using testing::ElementsAre;

const std::string kCaptureB =
    "FA FF 36 31 10 20 02 DF C5 10 60 04 00 45 9D A0 40 20 0C BE DC 9A FA 3F 54 9F 37 41 1C BB 70 "
    "80 20 0C BB AA 5C 80 3B 8C 55 01 BB 81 33 00 E0 20 04 00 00 00 81 45";
const std::string kCaptureC =
    "FA FF 36 14 10 20 02 00 09 20 30 0C BF BC 67 E0 3E DF AE 81 40 A3 A9 DF A7";
const std::string kCaptureD =
    "FA FF 36 16 10 60 04 09 3A 7C B7 20 30 0C BF 49 1A 52 BE C3 6A 10 C3 2E E2 EF 3E";
const std::string kCaptureE = "FA FF 36 0F 80 40 0C 3B 8B BC 00 BB E2 4F 00 3B 4E 4A 00 AF";

std::vector<XbusMessage> parse(const std::vector<Byte>& bytes) {
  XbusParser parser;
  parser.feed(bytes);
  std::vector<XbusMessage> messages;
  while (auto message = parser.next()) messages.push_back(*message);
  return messages;
}

MtSample sample_of(const std::string& capture) {
  const auto messages = parse(from_hex(capture));
  EXPECT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages.at(0).id, XbusId::kMtData2);
  const auto sample = decode_mtdata2(messages.at(0).payload);
  EXPECT_TRUE(sample.has_value());
  return *sample;
}

void expect_near(const std::optional<model::Vec3>& v, const model::Vec3& expected, double within) {
  ASSERT_TRUE(v.has_value());
  EXPECT_NEAR(v->x, expected.x, within);
  EXPECT_NEAR(v->y, expected.y, within);
  EXPECT_NEAR(v->z, expected.z, within);
}

TEST(Xbus, RequestsAreTheBytesOfTheProtocol) {
  EXPECT_EQ(encode_xbus(XbusId::kRequestDeviceId), from_hex("FA FF 00 00 01"));
  EXPECT_EQ(encode_xbus(XbusId::kGotoConfig), from_hex("FA FF 30 00 D1"));
  EXPECT_EQ(encode_xbus(XbusId::kGotoMeasurement), from_hex("FA FF 10 00 F1"));
  EXPECT_EQ(encode_xbus(XbusId::kWakeUpAck), from_hex("FA FF 3F 00 C2"));
  EXPECT_EQ(encode_xbus(XbusId::kReset), from_hex("FA FF 40 00 C1"));
  const std::vector<MtOutput> outputs{{0x1020, 0xFFFF}, {0x1060, 0xFFFF}, {0x2010, 100},
                                      {0x4020, 100},    {0x8020, 100},    {0xE020, 0xFFFF}};
  EXPECT_EQ(
      encode_xbus(XbusId::kSetOutputConfiguration, encode_outputs(outputs)),
      from_hex("FA FF C0 18 10 20 FF FF 10 60 FF FF 20 10 00 64 40 20 00 64 80 20 00 64 E0 20 "
               "FF FF 33"));
}

TEST(Xbus, ResponsesAreRead) {
  const auto id = parse(from_hex("FA FF 01 04 03 68 24 8C E1"));
  ASSERT_EQ(id.size(), 1u);
  EXPECT_EQ(id[0].id, XbusId::kDeviceId);
  EXPECT_THAT(id[0].payload, ElementsAre(0x03, 0x68, 0x24, 0x8C));
  const auto product =
      parse(from_hex("FA FF 1D 14 4D 54 69 2D 33 30 2D 32 41 38 47 34 20 20 20 20 20 20 20 20 E3"));
  ASSERT_EQ(product.size(), 1u);
  EXPECT_EQ(std::string(product[0].payload.begin(), product[0].payload.end()),
            "MTi-30-2A8G4        ");
}

TEST(Xbus, CapturesDecodeToTheirValues) {
  const MtSample a = sample_of(kCaptureA);
  EXPECT_EQ(a.sample_time, 39007691u);
  ASSERT_TRUE(a.quaternion);
  EXPECT_NEAR(a.quaternion->w, 0.999915, 1e-5);
  EXPECT_NEAR(a.quaternion->x, -0.002933, 1e-5);
  EXPECT_NEAR(a.quaternion->y, 0.012304, 1e-5);
  EXPECT_NEAR(a.quaternion->z, 0.003328, 1e-5);
  expect_near(a.rate_rad_s, {0.000487, -0.001807, -0.001025}, 1e-6);
  expect_near(a.acceleration_m_s2, {-0.2235, -0.0283, 9.8601}, 1e-4);
  EXPECT_EQ(a.status, 3u);

  const MtSample b = sample_of(kCaptureB);
  EXPECT_EQ(b.packet_counter, 57285);
  EXPECT_EQ(b.sample_time, 4562336u);
  EXPECT_FALSE(b.quaternion);
  expect_near(b.acceleration_m_s2, {-0.43087, 0.83055, 9.79576}, 1e-5);
  expect_near(b.rate_rad_s, {-0.005199, 0.004283, -0.003943}, 1e-6);
  EXPECT_EQ(b.status, 0x81u);

  EXPECT_EQ(sample_of(kCaptureC).packet_counter, 9);
  expect_near(sample_of(kCaptureC).euler_deg, {-1.472, 0.437, 5.114}, 1e-3);
  EXPECT_EQ(sample_of(kCaptureD).sample_time, 154827959u);
  expect_near(sample_of(kCaptureD).euler_deg, {-0.7856, -0.3817, -174.8865}, 1e-4);
  expect_near(sample_of(kCaptureE).rate_rad_s, {0.004264, -0.006906, 0.003148}, 1e-6);
}

// 0.5 and similar values in each format: 12.20, 16.32 (fraction before integer part), double.
TEST(Xbus, FixedPointAndDoubleAreRead) {
  const auto rate = [](const std::string& hex) {
    return decode_mtdata2(from_hex(hex)).value().rate_rad_s;
  };
  expect_near(rate("80 21 0C 00 08 00 00 FF F8 00 00 00 10 00 00"), {0.5, -0.5, 1.0}, 1e-9);
  expect_near(rate("80 22 12 80 00 00 00 00 00 80 00 00 00 FF FF 00 00 00 00 00 01"),
              {0.5, -0.5, 1.0}, 1e-9);
  expect_near(rate("80 23 18 3F E0 00 00 00 00 00 00 BF E0 00 00 00 00 00 00 3F F0 00 00 00 00 00 "
                   "00"),
              {0.5, -0.5, 1.0}, 1e-9);
}

TEST(Xbus, NorthEastDownIsTurnedOverSoThatUpIsUp) {
  // Level in NED is a half turn about x in a world with z up.
  const auto level =
      decode_mtdata2(from_hex("20 14 10 3F 80 00 00 00 00 00 00 00 00 00 00 00 00 00 00"));
  ASSERT_TRUE(level && level->quaternion);
  EXPECT_NEAR(rotate(*level->quaternion, {0, 0, 1}).z, -1.0, 1e-9);
}

TEST(Xbus, ImpossibleValuesAreMissing) {
  // NaN, a wrong length, a quaternion of norm 2.
  for (const char* hex :
       {"80 20 0C 7F C0 00 00 00 00 00 00 00 00 00 00", "80 20 0B 00 00 00 00 00 00 00 00 00 00 00",
        "20 10 10 40 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00"}) {
    const auto sample = decode_mtdata2(from_hex(hex));
    ASSERT_TRUE(sample.has_value()) << hex;
    EXPECT_FALSE(sample->rate_rad_s || sample->quaternion) << hex;
  }
  EXPECT_FALSE(decode_mtdata2(from_hex("10 20 03 00 00")).has_value()) << "longer than the payload";
}

std::vector<Byte> message_of(std::uint8_t id, const std::vector<Byte>& payload) {
  return encode_xbus(static_cast<XbusId>(id), payload);
}

RC_GTEST_PROP(XbusLaws, EveryMessageIsReadInAnyPieces, ()) {
  const auto id = *rc::gen::arbitrary<std::uint8_t>();
  const auto payload =
      *rc::gen::resize(600, rc::gen::container<std::vector<Byte>>(rc::gen::arbitrary<Byte>()));
  const auto bytes = message_of(id, payload);
  const auto cut = *rc::gen::inRange<std::size_t>(0, bytes.size() + 1);
  XbusParser parser;
  parser.feed(std::span(bytes).first(cut));
  auto message = parser.next();
  RC_ASSERT(message.has_value() == (cut == bytes.size()));
  if (!message) {
    parser.feed(std::span(bytes).subspan(cut));
    message = parser.next();
  }
  RC_ASSERT(message == (XbusMessage{static_cast<XbusId>(id), payload}));
  RC_ASSERT(parser.skipped() == 0u);
}

// Every byte of every capture, every wrong value. A sum of eight bits accepts one wrong length in
// 256; the list inside must then be rejected by its size.
TEST(Xbus, OneWrongByteNeverGivesAWrongSample) {
  for (const std::string& capture : {kCaptureA, kCaptureB, kCaptureC, kCaptureD, kCaptureE}) {
    const auto good = from_hex(capture);
    const XbusMessage original = parse(good).front();
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (int wrong = 1; wrong < 256; ++wrong) {
        auto bytes = good;
        bytes[at] = static_cast<Byte>(bytes[at] + wrong);
        for (int i = 0; i < 5; ++i) bytes.insert(bytes.end(), good.begin(), good.end());
        for (const XbusMessage& message : parse(bytes)) {
          if (message.id != XbusId::kMtData2 || message == original) continue;
          EXPECT_FALSE(decode_mtdata2(message.payload))
              << capture << " byte " << at << " + " << wrong;
        }
      }
    }
  }
}

TEST(Xbus, AWrongLengthSkipsAtMostThatLength) {
  auto bytes = from_hex(kCaptureC);
  bytes[3] = 0xFE;
  for (int i = 0; i < 20; ++i) {
    const auto good = from_hex(kCaptureC);
    bytes.insert(bytes.end(), good.begin(), good.end());
  }
  EXPECT_EQ(parse(bytes).size(), 20u);
}

RC_GTEST_PROP(XbusLaws, NoiseBetweenMessagesIsSkipped, (const std::vector<Byte>& raw)) {
  auto noise = raw;
  std::replace(noise.begin(), noise.end(), Byte{0xFA}, Byte{0});
  auto bytes = noise;
  const auto good = from_hex(kCaptureC);
  bytes.insert(bytes.end(), good.begin(), good.end());
  RC_ASSERT(parse(bytes) == parse(good));
}

TEST(Xbus, APreambleInsideABrokenMessageIsFound) {
  auto bytes = from_hex("FA FF 36 40 FA");  // cut off within a message
  const auto good = from_hex(kCaptureA);
  for (int i = 0; i < 2; ++i) bytes.insert(bytes.end(), good.begin(), good.end());
  EXPECT_EQ(parse(bytes).size(), 2u);
}

}  // namespace
}  // namespace hedgehog::device
