// SPDX-License-Identifier: MIT
// Reports of the DualSense and the DualShock 4, built byte by byte in hid-playstation.c's layout.
#include "daemon/device/imu/sony_pad.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "daemon/device/board_core/crc32.h"

namespace hedgehog::device {
namespace {

struct Variant {
  SonyPad pad;
  SonyBus bus;
  std::size_t bytes;
  Byte id;
  std::size_t gyro, accel, clock;
};
constexpr std::array<Variant, 4> kVariants{{
    {SonyPad::kDualSense, SonyBus::kUsb, 64, 0x01, 16, 22, 28},
    {SonyPad::kDualSense, SonyBus::kBluetooth, 78, 0x31, 17, 23, 29},
    {SonyPad::kDualShock4, SonyBus::kUsb, 64, 0x01, 13, 19, 10},
    {SonyPad::kDualShock4, SonyBus::kBluetooth, 78, 0x11, 15, 21, 12},
}};

void put(std::vector<Byte>& bytes, std::size_t at, int value) {
  bytes[at] = static_cast<Byte>(value);
  bytes[at + 1] = static_cast<Byte>(value >> 8);
}

void append_crc(std::vector<Byte>& bytes, Byte seed) {
  std::vector<Byte> covered{seed};
  covered.insert(covered.end(), bytes.begin(), bytes.end() - 4);
  const std::uint32_t crc = board::crc32(covered.data(), covered.size());
  for (std::size_t i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<Byte>(crc >> 8 * i);
}

std::vector<Byte> report_of(const Variant& v, const std::array<int, 3>& gyro,
                            const std::array<int, 3>& accel, std::uint32_t clock = 0) {
  std::vector<Byte> bytes(v.bytes);
  bytes[0] = v.id;
  for (std::size_t i = 0; i < 3; ++i) {
    put(bytes, v.gyro + 2 * i, gyro[i]);
    put(bytes, v.accel + 2 * i, accel[i]);
  }
  put(bytes, v.clock, static_cast<int>(clock & 0xFFFF));
  if (v.pad == SonyPad::kDualSense) put(bytes, v.clock + 2, static_cast<int>(clock >> 16));
  if (v.bus == SonyBus::kBluetooth) append_crc(bytes, 0xA1);
  return bytes;
}

/// 540 deg/s gives 8849 and -8837 about x, 8800 and -8840 about y, 8860 and -8820 about z, at
/// factory biases of 5, -3 and 2; 1 g gives 8200 and -8184 along each.
std::vector<Byte> calibration_of(const Variant& v) {
  const auto expected = calibration_report(v.pad, v.bus);
  std::vector<Byte> bytes(expected.bytes);
  bytes[0] = expected.id;
  const std::array<int, 3> bias{5, -3, 2};
  const std::array<int, 3> plus{8849, 8800, 8860};
  const std::array<int, 3> minus{-8837, -8840, -8820};
  const bool thirds = v.pad == SonyPad::kDualShock4 && v.bus == SonyBus::kBluetooth;
  for (std::size_t i = 0; i < 3; ++i) {
    put(bytes, 1 + 2 * i, bias[i]);
    put(bytes, thirds ? 7 + 2 * i : 7 + 4 * i, plus[i]);
    put(bytes, thirds ? 13 + 2 * i : 9 + 4 * i, minus[i]);
    put(bytes, 23 + 4 * i, 8200);
    put(bytes, 25 + 4 * i, -8184);
  }
  put(bytes, 19, 540);
  put(bytes, 21, 540);
  if (v.bus == SonyBus::kBluetooth) append_crc(bytes, 0xA3);
  return bytes;
}

class Sony : public testing::TestWithParam<Variant> {
 protected:
  const Variant& v = GetParam();
  SonyCalibration calibration = decode_calibration(v.pad, v.bus, calibration_of(v)).value();
};

TEST_P(Sony, CalibrationGivesDegreesAndG) {
  EXPECT_NEAR(calibration.gyro[0].scale, 1080.0 / (8849 + 8837), 1e-12);
  EXPECT_NEAR(calibration.gyro[1].scale, 1080.0 / (8800 + 8840), 1e-12);
  EXPECT_NEAR(calibration.gyro[2].scale, 1080.0 / (8860 + 8820), 1e-12);
  for (const auto& axis : calibration.gyro)
    EXPECT_EQ(axis.bias, 0.0) << "as hid-playstation has it";
  EXPECT_NEAR(calibration.accel[2].bias, 8.0, 1e-12);
}

// The maxima were measured including the bias, whatever its size: 30 are 1.8 deg/s.
TEST_P(Sony, TheFactoryBiasIsOfTheMaximaNotOfTheReports) {
  auto bytes = calibration_of(v);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool thirds = v.pad == SonyPad::kDualShock4 && v.bus == SonyBus::kBluetooth;
    put(bytes, 1 + 2 * i, 30);
    put(bytes, thirds ? 7 + 2 * i : 7 + 4 * i, 8870);
    put(bytes, thirds ? 13 + 2 * i : 9 + 4 * i, -8810);
  }
  if (v.bus == SonyBus::kBluetooth) append_crc(bytes, 0xA3);
  const auto made = decode_calibration(v.pad, v.bus, bytes).value();
  const auto at_rest = decode_sony(v.pad, report_of(v, {0, 0, 0}, {0, 8200, 0}), made);
  EXPECT_EQ(norm(at_rest->rate_deg_s), 0.0) << "1.8 deg/s off";
  const auto turned = decode_sony(v.pad, report_of(v, {8840, 0, 0}, {0, 8200, 0}), made);
  EXPECT_NEAR(turned->rate_deg_s.y, -540.0, 1e-9);
}

TEST_P(Sony, LyingFlatUpIsUp) {
  const auto sample = decode_sony(v.pad, report_of(v, {0, 0, 0}, {8, 8200, 8}), calibration);
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->accel_g.z, 1.0, 1e-9);
  EXPECT_NEAR(sample->accel_g.x, 0.0, 1e-9);
  EXPECT_NEAR(sample->accel_g.y, 0.0, 1e-9);
  EXPECT_NEAR(norm(sample->rate_deg_s), 0.0, 1e-9);
}

TEST_P(Sony, AxesAreForwardLeftUp) {
  // About the pad's own x axis (to the right): about the left axis it is negative.
  const auto pitch = decode_sony(v.pad, report_of(v, {8843, 0, 0}, {0, 0, 0}), calibration);
  EXPECT_NEAR(pitch->rate_deg_s.y, -540.0, 0.1);
  const auto yaw = decode_sony(v.pad, report_of(v, {0, 8820, 0}, {0, 0, 0}), calibration);
  EXPECT_NEAR(yaw->rate_deg_s.z, 540.0, 0.1);
  const auto roll = decode_sony(v.pad, report_of(v, {0, 0, 8840}, {0, 0, 0}), calibration);
  EXPECT_NEAR(roll->rate_deg_s.x, -540.0, 0.1);
}

TEST_P(Sony, TheClockWraps) {
  const double unit = v.pad == SonyPad::kDualSense ? 1.0 / 3 : 16.0 / 3;
  const std::uint32_t last = v.pad == SonyPad::kDualSense ? 0xFFFFFFFF : 0xFFFF;
  const auto at = [&](std::uint32_t clock) {
    return decode_sony(v.pad, report_of(v, {}, {}, clock), calibration)->clock_us;
  };
  EXPECT_NEAR(at(750), 750 * unit, 1e-6);
  EXPECT_NEAR(sony_elapsed_s(v.pad, at(last - 99), at(650)), 750 * unit * 1e-6, 1e-9);
}

TEST_P(Sony, OtherReportsAreRefused) {
  auto good = report_of(v, {1, 2, 3}, {4, 5, 6});
  auto longer = good;
  longer.push_back(0);
  EXPECT_FALSE(decode_sony(v.pad, longer, calibration));
  EXPECT_FALSE(decode_sony(v.pad, std::span(good).first(10), calibration));
  EXPECT_FALSE(decode_sony(v.pad, {}, calibration));
  EXPECT_FALSE(decode_calibration(v.pad, v.bus, good));
  EXPECT_FALSE(decode_calibration(v.pad, v.bus, {}));
}

// Over Bluetooth a wrong byte is detected by the CRC. USB has no CRC, but no byte can exceed the
// range of the sensors.
TEST_P(Sony, OneWrongByteIsDetectedOrHarmless) {
  const auto good = report_of(v, {100, -200, 300}, {8, 8200, 8}, 12345);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int wrong = 1; wrong < 256; ++wrong) {
      auto bad = good;
      bad[at] = static_cast<Byte>(bad[at] + wrong);
      const auto sample = decode_sony(v.pad, bad, calibration);
      if (v.bus == SonyBus::kBluetooth) {
        ASSERT_FALSE(sample) << at;
      } else if (sample) {
        ASSERT_LT(norm(sample->rate_deg_s), 4000.0);
        ASSERT_LT(norm(sample->accel_g), 8.0);
        ASSERT_GE(sample->clock_us, 0.0);
        ASSERT_LT(sample->clock_us, sony_clock_span_us(v.pad));
      }
    }
  }
}

TEST_P(Sony, OneWrongCalibrationByteIsDetectedOrHarmless) {
  const auto good = calibration_of(v);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int wrong = 1; wrong < 256; ++wrong) {
      auto bad = good;
      bad[at] = static_cast<Byte>(bad[at] + wrong);
      const auto made = decode_calibration(v.pad, v.bus, bad);
      if (v.bus == SonyBus::kBluetooth) {
        ASSERT_FALSE(made);
      } else if (made) {
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_GT(made->gyro[i].scale, 0.03);
          ASSERT_LT(made->gyro[i].scale, 0.13);
          ASSERT_GT(made->accel[i].scale, 6e-5);
          ASSERT_LT(made->accel[i].scale, 2.5e-4);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pads, Sony, testing::ValuesIn(kVariants), [](const auto& pad) {
  return std::string(pad.param.pad == SonyPad::kDualSense ? "DualSense" : "DualShock4") +
         (pad.param.bus == SonyBus::kUsb ? "_usb" : "_bluetooth");
});

TEST(SonyCalibration, ZerosOfAClonedPadAreNotDividedBy) {
  std::vector<Byte> zeros(41);
  zeros[0] = 0x05;
  const auto made = decode_calibration(SonyPad::kDualSense, SonyBus::kUsb, zeros);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->gyro[0].scale, SonyCalibration::nominal().gyro[0].scale);
  EXPECT_EQ(made->accel[2].bias, 0.0);
}

RC_GTEST_PROP(SonyLaws, NumbersAreDecoded, ()) {
  const Variant& v = kVariants[*rc::gen::inRange<std::size_t>(0, kVariants.size())];
  const auto number = rc::gen::inRange(-32768, 32768);
  const std::array<int, 3> gyro{*number, *number, *number};
  const std::array<int, 3> accel{*number, *number, *number};
  SonyCalibration plain;
  plain.gyro.fill({0.0, 1.0});
  plain.accel.fill({0.0, 1.0});
  const auto sample = decode_sony(v.pad, report_of(v, gyro, accel), plain);
  RC_ASSERT(sample.has_value());
  RC_ASSERT(sample->rate_deg_s == (model::Vec3{-1.0 * gyro[2], -1.0 * gyro[0], 1.0 * gyro[1]}));
  RC_ASSERT(sample->accel_g == (model::Vec3{-1.0 * accel[2], -1.0 * accel[0], 1.0 * accel[1]}));
}

}  // namespace
}  // namespace hedgehog::device
