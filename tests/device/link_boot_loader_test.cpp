// SPDX-License-Identifier: MIT
// How the link requests a board to enter its boot loader, and what the simulated board does then.
#include "daemon/device/simulator/lock_step.h"
#include "tests/device/exact_board.h"
#include "tests/device/link_bench.h"

namespace hedgehog::device {
namespace {

struct LinkBootLoader : LinkBench {
  bool is_requesting() const {
    if (!frames.other) return false;
    board::FrameHeader header;
    board::read_header(frames.other->data(), frames.other->size(), header);
    return header.type == board::FrameType::kBootLoader;
  }
};

TEST_F(LinkBootLoader, IsRequestedInFiftyFramesOnly) {
  tick();
  ++command.board.boot_loader_count;
  int requests = 0;
  for (int i = 0; i < 100; ++i) {
    tick();
    if (!is_requesting()) continue;
    ++requests;
    EXPECT_EQ(board::read_boot_loader(frames.other->data()).key, board::BootLoaderFrame::kKey);
  }
  EXPECT_EQ(requests, 50);
}

TEST_F(LinkBootLoader, IsNotRequestedFromABoardThatAppearsLater) {
  ++command.board.boot_loader_count;
  step();
  EXPECT_FALSE(is_requesting()) << "of a board that is absent";
  for (int i = 0; i < 200; ++i) {
    tick();
    ASSERT_FALSE(is_requesting());
  }
}

struct SimulatedBootLoader : testing::Test {
  LinkPort port;
  LockStep both{port, exact()};
  LinkCommand command;

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      ++command.count;
      port.commands.write(command);
      both.step();
    }
  }
  void request() { ++command.board.boot_loader_count; }
  bool present() const { return both.link().report().present; }
};

TEST_F(SimulatedBootLoader, ADisarmedBoardIsAbsentForThreeSecondsAndRestarts) {
  run(500);
  ASSERT_TRUE(present());
  request();
  run(150);
  EXPECT_FALSE(present());
  run(2700);
  EXPECT_FALSE(present());
  run(200);
  EXPECT_TRUE(present());
  EXPECT_EQ(both.board().core().mode(), board::Mode::kSafe);
  EXPECT_LT(both.board().core().now_ms(), 300u);
  run(200);
  EXPECT_TRUE(present()) << "it was asked once";
}

TEST_F(SimulatedBootLoader, ADrivingBoardStays) {
  run(5);
  ++command.board.arm_count;
  run(5);
  ASSERT_EQ(both.board().core().mode(), board::Mode::kReady);
  const BoardCommand idle = command.board;
  command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
  command.board.arm_count = idle.arm_count;
  run(20);
  ASSERT_EQ(both.board().core().mode(), board::Mode::kDriving);
  request();
  run(150);
  EXPECT_TRUE(present());
  EXPECT_EQ(both.board().core().mode(), board::Mode::kDriving);
}

TEST_F(SimulatedBootLoader, ABoardThatHasJustDrivenEntersItWhenNoCurrentFlows) {
  run(5);
  ++command.board.arm_count;
  run(5);
  const BoardCommand idle = command.board;
  command.board = BoardCommand::drive(limited({15, 0, 0}), kColdOhm, 1.5e-3, {15, 0, 0}, 12.0);
  command.board.arm_count = idle.arm_count;
  run(30);
  ASSERT_GT(model::norm(both.board().plant().current_a()), 14.0);
  command.board = idle;
  request();
  while (present() && model::norm(both.board().plant().current_a()) > 0.0) run(1);
  EXPECT_TRUE(present());
  run(150);
  EXPECT_FALSE(present());
}

}  // namespace
}  // namespace hedgehog::device
