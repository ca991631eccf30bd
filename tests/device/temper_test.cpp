// SPDX-License-Identifier: MIT
// Responses of TEMPer sticks, in the layouts of reference: hardware.md section 6.
#include "daemon/device/thermometer/temper.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/device/hex.h"

namespace hedgehog::device {
namespace {

const TemperModel kTwo = temper_model("TEMPer2_V3.9").value();

TEST(Temper, TheRequestsAreItsBytes) {
  EXPECT_EQ(std::vector<Byte>(kTemperAskFirmware.begin(), kTemperAskFirmware.end()),
            from_hex("01 86 FF 01 00 00 00 00"));
  EXPECT_EQ(std::vector<Byte>(kTemperAskTemperature.begin(), kTemperAskTemperature.end()),
            from_hex("01 80 33 01 00 00 00 00"));
}

TEST(Temper, TheFirmwareIsTheLeadingAscii) {
  EXPECT_EQ(temper_firmware(from_hex("54 45 4D 50 65 72 32 5F 56 33 2E 39 20 20 20 20")),
            "TEMPer2_V3.9");
  EXPECT_EQ(temper_firmware(from_hex("00 01 02")), "");
}

TEST(Temper, InsideAndProbe) {
  const auto reading =
      decode_temper(kTwo, from_hex("80 80 0A 8C 4E 20 00 00 80 01 0D DE 4E 20 00 00"));
  ASSERT_TRUE(reading);
  EXPECT_DOUBLE_EQ(reading->internal_c.value(), 27.00);
  EXPECT_DOUBLE_EQ(reading->external_c.value(), 35.50);
}

TEST(Temper, BelowZero) {
  EXPECT_DOUBLE_EQ(decode_temper(kTwo, from_hex("80 80 FE 0C 4E 20 00 00"))->internal_c.value(),
                   -5.00);
}

TEST(Temper, NoProbeNoNumber) {
  const auto unplugged =
      decode_temper(kTwo, from_hex("80 80 0A 8C 4E 20 00 00 80 01 4E 20 4E 20 00 00"));
  EXPECT_TRUE(unplugged->internal_c);
  EXPECT_FALSE(unplugged->external_c);
  EXPECT_FALSE(decode_temper(kTwo, from_hex("80 80 0A 8C 4E 20 00 00"))->external_c)
      << "one report";
}

TEST(Temper, FirmwareDecidesTheDivisor) {
  const auto old = temper_model("TEMPerF1.4").value();
  EXPECT_DOUBLE_EQ(decode_temper(old, from_hex("80 02 19 80 00 00 00 00"))->internal_c.value(),
                   25.5);
  const auto m12 = temper_model("TEMPer2_M12_V1.3").value();
  const auto reading = decode_temper(m12, from_hex("80 02 19 80 24 40 00 00"));
  EXPECT_DOUBLE_EQ(reading->internal_c.value(), 25.5);
  EXPECT_DOUBLE_EQ(reading->external_c.value(), 36.25);
  EXPECT_FALSE(temper_model("TEMPerNew_V9")) << "a guess would be worse than none";
  EXPECT_FALSE(temper_model(""));
}

TEST(Temper, OtherResponsesAreRefused) {
  EXPECT_FALSE(decode_temper(kTwo, {}));
  EXPECT_FALSE(decode_temper(kTwo, from_hex("80 80 0A")));
  EXPECT_FALSE(decode_temper(kTwo, from_hex("54 45 4D 50 65 72 32 5F")));
}

RC_GTEST_PROP(TemperLaws, HundredthsAreDecoded, ()) {
  const int raw = *rc::gen::inRange(-4000, 12501);
  std::vector<Byte> response(16);
  response[0] = 0x80;
  for (const std::size_t at : {std::size_t{2}, std::size_t{10}}) {
    response[at] = static_cast<Byte>(raw >> 8);
    response[at + 1] = static_cast<Byte>(raw);
  }
  const auto reading = decode_temper(kTwo, response);
  RC_ASSERT(reading.has_value());
  RC_ASSERT(reading->internal_c == raw / 100.0);
  RC_ASSERT(reading->external_c == raw / 100.0);
}

// There is no check sum: a wrong byte gives a plausible temperature, or none. The watchdog detects
// a wrong one, which must last for seconds.
RC_GTEST_PROP(TemperLaws, AnyBytesGiveAPossibleTemperatureOrNone, (std::vector<Byte> response)) {
  if (!response.empty()) response[0] = 0x80;
  for (const char* firmware : {"TEMPerF1.4", "TEMPer2_V3.9", "TEMPer2_M12_V1.3"}) {
    const auto reading = decode_temper(*temper_model(firmware), response);
    if (!reading) continue;
    for (const auto& value : {reading->internal_c, reading->external_c})
      if (value) RC_ASSERT(*value >= -40.0 && *value <= 125.0);
  }
}

}  // namespace
}  // namespace hedgehog::device
