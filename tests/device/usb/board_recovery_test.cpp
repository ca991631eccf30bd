// SPDX-License-Identifier: MIT
// Failures of the board on USB: unplugged, stalled, silent, failing, repeatedly.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <thread>

#include "daemon/device/usb/board_finder.h"
#include "daemon/device/usb/usb_board.h"
#include "tests/device/usb/usb_bench.h"

namespace hedgehog::device {
namespace {

TEST(BoardOnUsb, ABoardThatDoesNotReadFillsThePoolAndNoMore) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  board.listens = false;
  bench.run(board, 500);
  EXPECT_EQ(bench.sent, kWriteSlots);
  EXPECT_TRUE(bench.finder.usb_info().open);
  board.listens = true;
  bench.run(board, 100);
  EXPECT_GE(bench.sent, kWriteSlots + 99);
}

TEST(BoardOnUsb, UnpluggedDuringATransferItIsClosedAndFoundAgain) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  board.listens = false;  // frames to it stay in transfer
  bench.run(board, 300);
  board.plugged = false;
  bench.run(static_cast<int>(BoardFinder::kCheckPeriod.count()) + 2);
  EXPECT_FALSE(bench.finder.usb_info().open);
  EXPECT_FALSE(bench.finder.usb_info().serial);
  EXPECT_EQ(bench.what(), std::string(kSeven) + ": it was disconnected");
  EXPECT_EQ(board.open_ports, 0);
  EXPECT_EQ(board.still_submitted, 0);
  EXPECT_EQ(board.begun, board.ended);
  bench.run(2000);
  EXPECT_EQ(bench.what(), "no driver board is connected (1209:0001)");
  board.plugged = true;
  board.listens = true;
  const auto found = bench.until_open();
  ASSERT_TRUE(found);
  EXPECT_LE(*found, BoardFinder::kLongestPause.count());
  bench.received.clear();
  bench.run(board, 100);
  EXPECT_EQ(bench.received.size(), 100u);
}

TEST(BoardOnUsb, AStallIsClearedWithoutReopening) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 100);
  board.stalled = true;
  bench.run(board, static_cast<int>(BoardFinder::kCheckPeriod.count()) + 2);
  EXPECT_EQ(board.halts_cleared, 1);
  EXPECT_EQ(board.opened, 1);
  EXPECT_EQ(bench.finder.usb_info().recovered, 1u);
  const std::size_t before = bench.received.size();
  bench.run(board, 100);
  EXPECT_GE(bench.received.size(), before + 100);
}

TEST(BoardOnUsb, APersistentStallClosesItAndItIsReopenedWithBackoff) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 100);
  board.clear_halt_works = false;
  board.stalled = true;
  bench.run(60'000);
  // 0.25, 0.5, 1, 2, 4, 8, 8 ... s apart.
  EXPECT_GE(board.opened, 8);
  EXPECT_LE(board.opened, 14);
  EXPECT_EQ(board.begun, board.ended + (board.open_ports > 0 ? kReadSlots : 0));
  EXPECT_LE(board.open_ports, 1);
}

TEST(BoardOnUsb, RepeatedStallsLeadToAReopening) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  for (int i = 0; i <= BoardFinder::kMaxStalls; ++i) {
    bench.run(board, 100);
    board.stalled = true;
  }
  bench.run(board, 100);
  EXPECT_EQ(bench.finder.usb_info().recovered, static_cast<std::uint64_t>(BoardFinder::kMaxStalls));
  EXPECT_EQ(bench.finder.usb_info().closed, 1u);
}

TEST(BoardOnUsb, FailingTransfersAndSilenceCloseItToo) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 100);
  board.transfers_fail = true;
  bench.run(30);
  EXPECT_EQ(bench.what(), std::string(kSeven) + ": a transfer failed");
  board.transfers_fail = false;
  ASSERT_TRUE(bench.until_open());
  bench.run(static_cast<int>(BoardFinder::kSilence.count()) + 100);
  EXPECT_EQ(bench.what(), std::string(kSeven) + ": it sends no frames");
  EXPECT_EQ(board.open_ports, 0);
}

TEST(BoardOnUsb, WithoutABoardTheBusIsScannedOnceASecond) {
  Bench bench;
  bench.run(60'000);
  EXPECT_LE(bench.usb.listed, 63);
  EXPECT_LE(bench.steps, 63);
}

TEST(BoardOnUsb, AThousandPlugCyclesLoseNothing) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  for (int cycle = 0; cycle < 1000; ++cycle) {
    board.plugged = true;
    ASSERT_TRUE(bench.until_open()) << cycle;
    board.listens = cycle % 3 != 0;
    bench.run(board, 5);
    board.plugged = false;
    board.packets.clear();
    bench.run(25);
    ASSERT_EQ(board.open_ports, 0) << cycle;
  }
  EXPECT_EQ(board.opened, 1000);
  EXPECT_EQ(bench.finder.usb_info().opened, 1000u);
  EXPECT_EQ(bench.finder.usb_info().closed, 1000u);
  EXPECT_EQ(board.still_submitted, 0);
  EXPECT_EQ(board.begun, board.ended);
}

TEST(BoardOnUsb, ClosingSendsTheLastFrame) {
  Bench bench;
  FakeBoard& board = bench.usb.plug_in("7");
  bench.run(board, 10);
  const auto sent = static_cast<std::size_t>(bench.sent);
  bench.finder.close();
  EXPECT_EQ(board.on_event.size(), sent);
  EXPECT_EQ(board.open_ports, 0);
  EXPECT_EQ(board.still_submitted, 0);
}

RC_GTEST_PROP(BoardOnUsb, NothingIsLostOrLeftOpenUnderAnyFaults, ()) {
  const auto faults = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 9));
  auto bench = std::make_unique<Bench>();
  FakeBoard& board = bench->usb.plug_in("7");
  for (const int one : faults) {
    if (one == 0) board.plugged = !board.plugged;
    if (one == 1) board.stalled = true;
    if (one == 2) board.listens = !board.listens;
    if (one == 3) board.transfers_fail = !board.transfers_fail;
    if (one == 4) board.clear_halt_works = !board.clear_halt_works;
    if (one == 5) board.open_error = board.open_error == 0 ? LIBUSB_ERROR_ACCESS : 0;
    bench->run(board, 40 * one);
    RC_ASSERT(board.open_ports <= 1);
    RC_ASSERT(board.begun - board.ended <= static_cast<std::uint64_t>(kSlots));
  }
  bench->finder.close();
  RC_ASSERT(board.open_ports == 0);
  RC_ASSERT(board.still_submitted == 0);
  RC_ASSERT(board.begun == board.ended);
  RC_ASSERT(bench->finder.usb_info().opened == bench->finder.usb_info().closed);
}

// Real threads: the link's tick, the finder's own thread, and cables unplugged meanwhile.
TEST(BoardOnUsb, FinderAndLinkOnThreadsOfTheirOwn) {
  auto usb = std::make_unique<FakeUsb>();
  FakeBoard& plugged = usb->plug_in("7");
  for (int i = 1; i <= 4000; ++i)
    plugged.packets.push_back(telemetry(static_cast<std::uint32_t>(i)));
  UsbBoard board(std::move(usb), kAny);
  {
    const auto transport = board.transport();
    std::array<std::uint8_t, 128> packet;
    std::uint32_t next = 1;
    while (next <= 4000) {
      if (transport->receive(packet) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      ASSERT_TRUE(std::equal(packet.begin(), packet.begin() + 64, telemetry(next).begin()));
      ++next;
      (void)transport->send(Frame{});
    }
    // The finder provides the board a moment before it reports so.
    for (int ms = 0; ms < 20'000 && !board.usb_info().open; ++ms)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(board.usb_info().what, kSeven);
  }
}

}  // namespace
}  // namespace hedgehog::device
