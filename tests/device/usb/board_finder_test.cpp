// SPDX-License-Identifier: MIT
// Which board is used, what is reported about the others, and which frames pass.
#include "daemon/device/usb/board_finder.h"

#include <gtest/gtest.h>

#include "tests/device/usb/usb_bench.h"

namespace hedgehog::device {
namespace {

TEST(BoardOnUsb, NoneIsConnected) {
  Bench bench;
  bench.run(100);
  EXPECT_FALSE(bench.finder.usb_info().open);
  EXPECT_FALSE(bench.finder.usb_info().seen);
  EXPECT_EQ(bench.what(), "no driver board is connected (1209:0001)");
  EXPECT_EQ(bench.sent, 0);
}

TEST(BoardOnUsb, TheOneThatIsConnectedIsUsedByItsVendorInterface) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 1000);
  EXPECT_TRUE(bench.finder.usb_info().open);
  EXPECT_EQ(bench.what(), kSeven);
  EXPECT_EQ(bench.finder.usb_info().serial, "7");
  EXPECT_EQ(bench.finder.usb_info().firmware, "1.02");
  EXPECT_EQ(bench.usb.claimed_interface, 1);
  EXPECT_EQ(bench.received.size(), 1000u);
  EXPECT_EQ(board.on_event.size(), static_cast<std::size_t>(bench.sent) - 1);  // one in transfer
  EXPECT_EQ(bench.sent, 1000);
  for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(bench.received[i], telemetry(i + 1));
}

TEST(BoardOnUsb, OfTwoNeitherIsUsedUnlessTheDeviceFileNamesOne) {
  Bench bench;
  bench.usb.plug_in("7");
  bench.usb.plug_in("8");
  bench.run(100);
  EXPECT_TRUE(bench.finder.usb_info().seen);
  EXPECT_EQ(bench.what(), std::string("two driver boards are connected, ") + kSeven +
                              " and Hedgehog driver board (1209:0001), serial number 8, firmware "
                              "1.02; `usb_serial` in the device file says which");
  EXPECT_EQ(bench.usb.boards[0]->opened + bench.usb.boards[1]->opened, 0);

  Bench named({kAny.ids, "8"});
  named.usb.plug_in("7");
  FakeBoard& eight = named.usb.plug_in("8");
  named.run(eight, 100);
  EXPECT_TRUE(named.finder.usb_info().open);
  EXPECT_EQ(eight.opened, 1);
  EXPECT_EQ(named.usb.boards[0]->opened, 0);
}

TEST(BoardOnUsb, AnotherSerialNumberIsNamed) {
  Bench bench({kAny.ids, "9"});
  bench.usb.plug_in("7");
  bench.run(100);
  EXPECT_EQ(bench.what(),
            std::string("no driver board with serial number 9 is connected, only ") + kSeven);
}

TEST(BoardOnUsb, AnInterfaceOfAnotherVersionIsNamedWithBoth) {
  Bench bench;
  bench.usb.plug_in("7", 2);
  bench.run(100);
  EXPECT_EQ(
      bench.what(),
      std::string(kSeven) +
          ": it speaks version 2 of the board protocol, this hedgehogd 1; update one of them");
  EXPECT_EQ(bench.usb.boards[0]->opened, 0);
}

TEST(BoardOnUsb, FramesOfAnotherVersionAreNamedWithBoth) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 100, 3);
  EXPECT_FALSE(bench.finder.usb_info().open);
  EXPECT_NE(bench.what().find("version 3 of the board protocol, this hedgehogd 1"),
            std::string::npos);
  EXPECT_EQ(board.open_ports, 1);
}

TEST(BoardOnUsb, NoiseIsNoVersion) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  auto broken = telemetry(1, 3);
  broken[20] ^= 1;
  board.packets = {broken, std::vector<std::uint8_t>(64, 0x55), {1, 2}};
  bench.run(50);
  EXPECT_TRUE(bench.finder.usb_info().open);
  EXPECT_EQ(bench.what(), kSeven);
}

TEST(BoardOnUsb, SomethingElseWithItsIdsIsNoBoard) {
  Bench bench;
  bench.usb.plug_in("7").device.interfaces = {{0, 0x03, 0x01, 0x01}};
  bench.run(100);
  EXPECT_EQ(bench.what(), std::string(kSeven) + ": it has no interface of a driver board");
}

TEST(BoardOnUsb, MissingPermissionAndAnotherProgramAreDistinguished) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  board.open_error = LIBUSB_ERROR_ACCESS;
  bench.run(100);
  EXPECT_TRUE(bench.finder.usb_info().seen);
  EXPECT_EQ(bench.what(), std::string(kSeven) +
                              ": no permission to open it; the udev rule gives it to the group "
                              "hedgehog");
  board.open_error = LIBUSB_ERROR_BUSY;
  bench.run(500);
  EXPECT_EQ(bench.what(), std::string(kSeven) + ": another program has it");
  board.open_error = 0;
  EXPECT_LE(*bench.until_open(), 1000);
}

TEST(BoardOnUsb, ShortAndLongPacketsAreForwardedUnchangedAndEmptyOnesNot) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  const std::vector<std::uint8_t> longest(kSlotBytes, 9);
  board.packets = {{1, 2, 3}, {}, telemetry(1), longest, telemetry(2)};
  bench.run(50);
  ASSERT_EQ(bench.received.size(), 4u);
  EXPECT_EQ(bench.received[0], (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(bench.received[1], telemetry(1));
  EXPECT_EQ(bench.received[2], std::vector<std::uint8_t>(128, 9));  // longer than any frame
  EXPECT_EQ(bench.received[3], telemetry(2));
}

TEST(BoardOnUsb, AfterAPauseOfTheLinkThePacketsAreInOrder) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(50);
  for (std::uint32_t i = 1; i <= 300; ++i) board.packets.push_back(telemetry(i));
  bench.run(1);
  ASSERT_EQ(bench.received.size(), 300u);
  for (std::uint32_t i = 0; i < 300; ++i) EXPECT_EQ(bench.received[i], telemetry(i + 1));
}

}  // namespace
}  // namespace hedgehog::device
