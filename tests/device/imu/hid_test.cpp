// SPDX-License-Identifier: MIT
// HID report descriptors and the orientation decoded by them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "daemon/device/imu/hid_descriptor.h"
#include "daemon/device/imu/hid_orientation.h"
#include "tests/device/hid_examples.h"

namespace hedgehog::device {
namespace {

using Kind = HidField::Kind;
using testing::ElementsAre;

HidOrientation sensor_of(const std::vector<Byte>& descriptor) {
  auto parsed = parse_hid_descriptor(descriptor);
  EXPECT_TRUE(parsed.has_value());
  auto found = HidOrientation::find(*parsed);
  EXPECT_TRUE(found.has_value());
  return *found;
}

void expect_rotation(const std::optional<HidOrientationSample>& sample, const model::Vec3& axis,
                     double angle_deg, double within = 1e-3) {
  ASSERT_TRUE(sample.has_value());
  const model::Quaternion expected = model::axis_angle(axis, angle_deg);
  const model::Quaternion d = conjugate(expected) * sample->quaternion;
  EXPECT_NEAR(std::abs(d.w), 1.0, within);
}

TEST(HidDescriptor, ReadsFieldsUnitsAndExponents) {
  const auto parsed = parse_hid_descriptor(short_orientation_descriptor());
  ASSERT_TRUE(parsed);
  EXPECT_TRUE(parsed->has_ids);
  const auto quaternion = hid_elements(*parsed, Kind::kInput, 0x200483);
  ASSERT_EQ(quaternion.size(), 4u);
  const HidField& field = parsed->fields[quaternion[0].field];
  EXPECT_EQ(field.report_id, 5);
  EXPECT_EQ(field.bits, 16u);
  EXPECT_EQ(field.exponent, -3);
  EXPECT_EQ(field.logical_min, -1000);
  EXPECT_EQ(field.bit_offset, 16u) << "behind state and event";
  EXPECT_THAT(field.collections, ElementsAre(0x200001, 0x20008A));
  EXPECT_EQ(parsed->report_bytes(Kind::kInput, 5), 2 + 8u);
  EXPECT_EQ(parsed->report_bytes(Kind::kFeature, 5), 6u);
  EXPECT_EQ(parsed->report_bytes(Kind::kOutput, 5), 0u);
}

TEST(HidDescriptor, RefusesInvalidOnes) {
  const auto good = short_orientation_descriptor();
  for (std::size_t cut = 5; cut < good.size(); ++cut) {
    const auto parsed = parse_hid_descriptor(std::span(good).first(cut));
    EXPECT_FALSE(parsed.has_value()) << cut << ": a collection is still open";
  }
  EXPECT_FALSE(parse_hid_descriptor(std::vector<Byte>{0xC0})) << "nothing to end";
  EXPECT_FALSE(parse_hid_descriptor(std::vector<Byte>{0xB4})) << "nothing to pop";
  EXPECT_FALSE(parse_hid_descriptor(std::vector<Byte>{0x85, 0x00})) << "report id 0";
  EXPECT_FALSE(parse_hid_descriptor(
      std::vector<Byte>{0x05, 0x20, 0x09, 0x01, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x75, 32, 0x81, 2}))
      << "4294967295 numbers";
}

// s16, exponent -3, id 5: (x, y, z, w) = (0, 0, 0.707, 0.707) turns by 90 degrees about up.
TEST(HidOrientation, ShortsWithAnExponent) {
  const HidOrientation sensor = sensor_of(short_orientation_descriptor());
  EXPECT_EQ(sensor.report_id(), 5);
  const std::vector<Byte> report{5, 2, 4, 0, 0, 0, 0, 0xC3, 0x02, 0xC3, 0x02};
  // The sensor's y, which is the front here, is rotated from north to west; without a rotation it
  // would be 90 degrees from the world's x.
  expect_rotation(sensor.decode(report), {0, 0, 1}, 180.0);
  EXPECT_FALSE(sensor.decode(report)->rate_deg_s);
  const std::vector<Byte> still{5, 2, 4, 0, 0, 0, 0, 0, 0, 0xE8, 0x03};
  expect_rotation(sensor.decode(still), {0, 0, 1}, 90.0);
}

// s32, exponent -7, no report ids, followed by the angular velocity in radians.
TEST(HidOrientation, LongsWithAngularVelocityInRadians) {
  const HidOrientation sensor = sensor_of(long_orientation_descriptor());
  EXPECT_EQ(sensor.report_id(), 0);
  std::vector<Byte> report;
  const auto put = [&](std::int32_t value) {
    for (int i = 0; i < 4; ++i) report.push_back(static_cast<Byte>(value >> (8 * i)));
  };
  for (const std::int32_t value : {7071068, 0, 0, 7071068}) put(value);  // 90 degrees about x
  for (const std::int32_t value : {1000, -2000, 3000}) put(value);       // mrad/s
  const auto sample = sensor.decode(report);
  ASSERT_TRUE(sample);
  // The sensor's x is the ball's right side: its left side goes down, its front goes up.
  EXPECT_NEAR(rotate(sample->quaternion, {1, 0, 0}).z, 1.0, 1e-6);
  ASSERT_TRUE(sample->rate_deg_s);
  EXPECT_NEAR(sample->rate_deg_s->x, -114.59, 0.01);
  EXPECT_NEAR(sample->rate_deg_s->y, -57.30, 0.01);
  EXPECT_NEAR(sample->rate_deg_s->z, 171.89, 0.01);
}

TEST(HidOrientation, WithoutAnExponentTheFullRangeIsOne) {
  const HidOrientation sensor = sensor_of(full_range_orientation_descriptor());
  const std::vector<Byte> report{0, 0, 0, 0, 0, 0, 0xFF, 0x7F};
  expect_rotation(sensor.decode(report), {0, 0, 1}, 90.0);
}

TEST(HidOrientation, SwitchesItOnByItsFeatureReport) {
  const HidOrientation sensor = sensor_of(short_orientation_descriptor());
  ASSERT_THAT(sensor.feature_ids(), ElementsAre(5));
  std::vector<Byte> report(sensor.feature_bytes(5));
  ASSERT_EQ(report.size(), 7u);
  report[0] = 5;
  sensor.switch_on(report, 0.01);
  // "all events" and "full power" are the second selectors of lists that start at 1; 10 ms.
  EXPECT_THAT(report, ElementsAre(5, 2, 2, 10, 0, 0, 0));
}

TEST(HidOrientation, OtherDevicesHaveNone) {
  EXPECT_FALSE(HidOrientation::find(*parse_hid_descriptor(mouse_descriptor())));
}

TEST(HidOrientation, OtherReportsAndShortOnesAreIgnored) {
  const HidOrientation sensor = sensor_of(short_orientation_descriptor());
  EXPECT_FALSE(sensor.decode({}));
  EXPECT_FALSE(sensor.decode(std::vector<Byte>{4, 2, 4, 0, 0, 0, 0, 0, 0, 0xE8, 0x03}));
  EXPECT_FALSE(sensor.decode(std::vector<Byte>{5, 2, 4, 0, 0, 0, 0, 0, 0, 0xE8}));
  EXPECT_FALSE(sensor.decode(std::vector<Byte>(11, 5))) << "no unit length";
}

RC_GTEST_PROP(HidLaws, NumbersAreReadFromAnyBits, ()) {
  HidField field;
  field.bits = *rc::gen::inRange<std::uint32_t>(1, 33);
  field.count = *rc::gen::inRange<std::uint32_t>(1, 9);
  field.bit_offset = *rc::gen::inRange<std::uint32_t>(0, 40);
  const bool with_sign = *rc::gen::arbitrary<bool>();
  field.logical_min = with_sign ? -1 : 0;
  const auto index = *rc::gen::inRange<std::uint32_t>(0, field.count);
  const std::int64_t span = std::int64_t{1} << field.bits;
  const std::int64_t value = *rc::gen::inRange<std::int64_t>(0, span) - (with_sign ? span / 2 : 0);
  std::vector<Byte> report((field.bit_offset + field.bits * field.count + 7) / 8, 0xA5);
  const auto before = report;
  RC_ASSERT(write_hid(field, index, value, report));
  RC_ASSERT(read_hid(field, index, report) == value);
  for (std::uint32_t other = 0; other < field.count; ++other)
    if (other != index) RC_ASSERT(read_hid(field, other, report) == read_hid(field, other, before));
  RC_ASSERT(!read_hid(field, field.count, report));
}

// A report has no check sum: one wrong byte may rotate the ball a little, but never yields an
// invalid number.
RC_GTEST_PROP(HidLaws, AnyReportGivesARotationOrNothing, (const std::vector<Byte>& noise)) {
  for (const auto& descriptor : {short_orientation_descriptor(), long_orientation_descriptor(),
                                 full_range_orientation_descriptor()}) {
    const HidOrientation sensor = sensor_of(descriptor);
    auto report = noise;
    report.resize(30);
    report[0] = sensor.report_id();
    if (const auto sample = sensor.decode(report)) {
      RC_ASSERT(std::abs(norm(sample->quaternion) - 1.0) < 1e-9);
      RC_ASSERT(is_finite(sample->rate_deg_s.value_or(model::Vec3{})));
    }
  }
}

TEST(HidDescriptor, OneWrongByteIsRefusedOrHarmless) {
  for (const auto& good : {short_orientation_descriptor(), long_orientation_descriptor()}) {
    const std::vector<Byte> report(64, 0x3C);
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (int wrong = 1; wrong < 256; ++wrong) {
        auto bad = good;
        bad[at] = static_cast<Byte>(bad[at] + wrong);
        const auto parsed = parse_hid_descriptor(bad);
        if (!parsed) continue;
        for (const HidField& field : parsed->fields) {
          ASSERT_LE(field.bits, 32u);
          ASSERT_FALSE(field.usages.empty());
          (void)read_hid(field, field.count - 1, report);
        }
        const auto sensor = HidOrientation::find(*parsed);
        const auto sample = sensor ? sensor->decode(report) : std::nullopt;
        if (sample) ASSERT_NEAR(norm(sample->quaternion), 1.0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace hedgehog::device
