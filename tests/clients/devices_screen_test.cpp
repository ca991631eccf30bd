// SPDX-License-Identifier: MIT
// The exact output of `hedgehogctl devices`.
#include "clients/ctl/screen/devices_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

TEST(DevicesScreen, ListsDevicesInUseAndWhyOthersAreNot) {
  protocol::DevicesResult seen;
  seen.devices = {
      {"USB 1-3", "1209:0001", "Hedgehog driver board", "7", "1.02", "1.2", "board", {}},
      {"USB 1-4", "2639:0003", "Xsens MTi-30", {}, {}, {}, "imu", {}},
      {"USB 1-6",
       "413d:2107",
       "TEMPer2",
       {},
       {},
       {},
       {},
       "no permission to open it; the udev rule gives it to the group hedgehog"}};
  seen.missing = {{"thermometer", "no TEMPer thermometer is connected"}};
  seen.others = 2;
  EXPECT_THAT(devices_screen(seen, "ball-7"),
              testing::ElementsAre(
                  "  USB 1-3    1209:0001  Hedgehog driver board 7, firmware 1.02, protocol 1.2",
                  "                        is ball-7",
                  "  USB 1-4    2639:0003  Xsens MTi-30                is its orientation",
                  "  USB 1-6    413d:2107  TEMPer2                     not used: no permission to",
                  "                        open it; the udev rule gives it to the group hedgehog",
                  "  missing               thermometer: no TEMPer thermometer is connected",
                  "  and 2 more that hedgehogd does not use"));
  for (const std::string& line : devices_screen(seen, std::string(32, 'b')))
    EXPECT_LE(columns(line), 80u) << line;
  const auto into_a_pipe = devices_screen(seen, "ball-7", {.cuts = false});
  EXPECT_THAT(
      into_a_pipe,
      testing::ElementsAre(
          "  USB 1-3    1209:0001  Hedgehog driver board 7, firmware 1.02, protocol 1.2  is "
          "ball-7",
          "  USB 1-4    2639:0003  Xsens MTi-30                is its orientation",
          "  USB 1-6    413d:2107  TEMPer2                     not used: no permission to "
          "open it; the udev rule gives it to the group hedgehog",
          "  missing               thermometer: no TEMPer thermometer is connected",
          "  and 2 more that hedgehogd does not use"));
}

TEST(DevicesScreen, AMachineWithoutDevices) {
  EXPECT_THAT(devices_screen({}, "ball"),
              testing::ElementsAre("  no supported device is connected"));
}

}  // namespace
}  // namespace hedgehog::client
