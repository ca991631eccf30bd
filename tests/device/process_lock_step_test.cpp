// SPDX-License-Identifier: MIT
// A board behind a socket in lock-step with its host: nothing here depends on how long either of
// them takes.
#include "daemon/device/simulator/process_lock_step.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>
#include <utility>

#include "daemon/device/simulator/simulated_board_runner.h"
#include "daemon/device/socket_transport.h"
#include "tests/device/exact_board.h"
#include "tests/device/limited.h"

namespace hedgehog::device {
namespace {

class InStep : public testing::Test {
 protected:
  InStep() {
    auto [host, board] = make_socket_pair();
    host_ = std::make_unique<ProcessLockStep>(*port_,
                                              std::make_unique<SocketTransport>(std::move(host)));
    board_ = std::thread([socket = std::make_shared<FileDescriptor>(std::move(board))] {
      auto transport = std::make_unique<SocketTransport>(std::move(*socket));
      const SocketTransport& host_end = *transport;
      SimulatedBoardRunner runner(exact(), std::move(transport));
      runner.run_in_step(host_end);
      runner.run(std::atomic<bool>{false});
    });
  }
  ~InStep() override {
    host_.reset();
    board_.join();
  }

  void run(int ms, bool driving) {
    for (int i = 0; i < ms; ++i) {
      const std::uint8_t arm_count = command_.board.arm_count;
      command_.board =
          driving ? BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0)
                  : BoardCommand{};
      command_.board.arm_count = arm_count;
      ++command_.count;
      port_->commands.write(command_);
      host_->step();
    }
  }
  const LinkReport& report() { return port_->reports.read(); }

  std::unique_ptr<LinkPort> port_ = std::make_unique<LinkPort>();
  LinkCommand command_;
  std::unique_ptr<ProcessLockStep> host_;
  std::thread board_;
};

TEST_F(InStep, EachStepIsAMillisecondOfTheBoard) {
  run(20, false);
  const std::uint32_t before = report().telemetry.board_ms;
  const auto frames = report().telemetry_count;
  run(500, false);
  EXPECT_EQ(report().telemetry.board_ms - before, 500u);
  EXPECT_EQ(report().telemetry_count - frames, 500u);
  EXPECT_TRUE(report().present);
}

TEST_F(InStep, TheTrueStateIsThatOfTheLastMillisecond) {
  run(20, false);
  ++command_.board.arm_count;
  run(100, true);
  EXPECT_EQ(report().telemetry.mode, BoardMode::kDriving);
  EXPECT_NEAR(port_->truth.read().current_a.x, 5.0, 0.1);
  EXPECT_NEAR(report().telemetry.current_a.x, 5.0, 0.2);
}

TEST(ProcessLockStep, AHostWithoutABoardContinues) {
  auto [host, board] = make_socket_pair();
  LinkPort port;
  ProcessLockStep step(port, std::make_unique<SocketTransport>(std::move(host)));
  { const FileDescriptor closed = std::move(board); }
  for (int i = 0; i < 200; ++i) step.step();
  EXPECT_FALSE(port.reports.read().present);
}

TEST(ProcessLockStep, ABoardThatHangsIsWaitedForOnce) {
  auto [host, board] = make_socket_pair();
  LinkPort port;
  ProcessLockStep step(port, std::make_unique<SocketTransport>(std::move(host)), 10);
  SocketTransport silent(std::move(board));
  step.step();
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  int packets = 0;
  while (silent.receive(packet) > 0) ++packets;
  EXPECT_FALSE(silent.open()) << "the host's end is closed";
  EXPECT_GT(packets, 0);
  for (int i = 0; i < 200; ++i) step.step();
  EXPECT_FALSE(port.reports.read().present);
}

}  // namespace
}  // namespace hedgehog::device
