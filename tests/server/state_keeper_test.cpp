// SPDX-License-Identifier: MIT
// The state file when the disk is slower than the daemon, or refuses.
#include "daemon/server/state_keeper.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>

#include "daemon/daemon.h"
#include "daemon/server/disk_thread.h"
#include "daemon/server/machine.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

TEST(StateKeeper, TheOrderlyStopIsTheLastThingThatIsWritten) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("hedgehog-state-keeper-test-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  control::StatusSnapshot snapshot;
  snapshot.tick = 1;
  mailbox->status.write(snapshot);
  Machine machine(config::Config{}, *mailbox, *port, 0);
  std::promise<void> slow;
  {
    DiskThread disk;
    ASSERT_TRUE(disk.post(DiskUse::kSafety, [wait = slow.get_future().share()] { wait.wait(); }));
    StateKeeper keeper(folder.string(), disk, machine, std::nullopt);
    keeper.remember_gain(0.5);
    keeper.pump();  // waits behind the slow job
    keeper.stopped_cleanly();
    slow.set_value();
  }
  const auto state = load_saved_state(folder.string());
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->clean_stop);
  EXPECT_EQ(state->gain, 0.5);
}

TEST(StateKeeper, TheHeatOfTheLastRunStaysUntilAThermistorHasBeenSeen) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("hedgehog-state-keeper-heat-test-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  SavedState last;
  last.wall_time_s = 1000.0;
  last.heat_known = true;
  last.heat = {{55.0, 56.0, 57.0}, 50.0};
  last.room_c = 21.0;
  control::StatusSnapshot snapshot;
  snapshot.tick = 1;
  mailbox->status.write(snapshot);
  Machine machine(config::Config{}, *mailbox, *port, 0);
  const auto after = [&](auto&& what) {
    {
      DiskThread disk;
      StateKeeper keeper(folder.string(), disk, machine, last);
      what(keeper);
      keeper.stopped_cleanly();
    }
    return load_saved_state(folder.string()).value_or(SavedState{});
  };
  const SavedState without_board = after([](StateKeeper& keeper) {
    keeper.remember_latch(control::Reason::kEmergencyStop);
    keeper.pump();
  });
  EXPECT_TRUE(without_board.heat_known);
  EXPECT_EQ(without_board.heat.winding_c, last.heat.winding_c);
  EXPECT_EQ(without_board.wall_time_s, 1000.0) << "it has cooled since then, not since now";
  EXPECT_EQ(without_board.latch, control::Reason::kEmergencyStop);

  snapshot.board_present = true;
  snapshot.sensor_valid = true;
  snapshot.thermal.nodes = {{31.0, 31.0, 31.0}, 30.0};
  snapshot.thermal.measured = {false, true, false};
  mailbox->status.write(snapshot);
  machine.refresh();
  const SavedState with_board = after([](StateKeeper& keeper) { keeper.pump(); });
  std::filesystem::remove_all(folder);
  EXPECT_EQ(with_board.heat.winding_c, snapshot.thermal.nodes.winding_c);
  EXPECT_TRUE(with_board.heat_known);
  EXPECT_EQ(with_board.measured, snapshot.thermal.measured);
  EXPECT_GT(with_board.wall_time_s, 1000.0);
}

/// A ball at rest, whose state file can be made to refuse.
struct RefusingDisk : testing::Test {
  void SetUp() override {
    snapshot.tick = 1;
    say();
    last.clean_stop = true;
    ASSERT_EQ(write_file_atomically(folder.path("state.json"), encode(last)), "");
  }
  void say() {
    mailbox->status.write(snapshot);
    machine.refresh();
  }
  /// Stands in for a full disk: nothing can be written beside the file, and it can be removed.
  void refuse() const { std::filesystem::create_directory(folder.path("state.json.new")); }
  void allow() const { std::filesystem::remove(folder.path("state.json.new")); }
  static void settle(DiskThread& disk) {
    std::promise<void> done;
    ASSERT_TRUE(disk.post(DiskUse::kSafety, [&done] { done.set_value(); }));
    done.get_future().wait();
  }
  std::optional<SavedState> on_disk() const { return load_saved_state(folder.path()); }
  bool next_start_arms() const {
    config::Config real;
    real.backend = config::Backend::kUsb;
    const auto settings = daemon::start_state(real, on_disk(), 0.0).settings;
    return settings.arm_at_start && settings.latch == control::Reason::kNone;
  }

  const TemporaryFolder folder;
  std::unique_ptr<control::Mailbox> mailbox = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
  control::StatusSnapshot snapshot;
  Machine machine{config::Config{}, *mailbox, *port, 0};
  SavedState last;
  std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
};

TEST_F(RefusingDisk, DoesNotKeepTheWordOfTheLastOrderlyStop) {
  ASSERT_TRUE(next_start_arms());
  refuse();
  DiskThread disk;
  StateKeeper keeper(folder.path(), disk, machine, last);
  EXPECT_FALSE(next_start_arms()) << "a kill from here on is no orderly stop";
  keeper.remember_latch(control::Reason::kEmergencyStop);
  keeper.stopped_cleanly();
  settle(disk);
  EXPECT_FALSE(next_start_arms());
}

TEST_F(RefusingDisk, IsAskedAgainEachSecondUntilItHasTheLatch) {
  DiskThread disk;
  StateKeeper keeper(folder.path(), disk, machine, last);
  refuse();
  keeper.pump(now);
  snapshot.latch = control::Reason::kEmergencyStop;
  say();
  keeper.remember_latch(control::Reason::kEmergencyStop);
  settle(disk);
  keeper.pump(now += std::chrono::seconds(1));
  settle(disk);
  EXPECT_EQ(on_disk()->latch, control::Reason::kNone);
  EXPECT_FALSE(next_start_arms());
  allow();
  keeper.pump(now += std::chrono::milliseconds(900));
  settle(disk);
  EXPECT_EQ(on_disk()->latch, control::Reason::kNone) << "not as fast as it turns";
  keeper.pump(now += std::chrono::milliseconds(100));
  settle(disk);
  ASSERT_EQ(on_disk()->latch, control::Reason::kEmergencyStop);
  std::filesystem::remove(folder.path("state.json"));
  keeper.pump(now += std::chrono::seconds(5));
  settle(disk);
  EXPECT_FALSE(on_disk()) << "written again without need";
}

TEST_F(RefusingDisk, DoesNotKeepAnOrderlyStopThatAnEmergencyStopFollowed) {
  {
    DiskThread disk;
    StateKeeper keeper(folder.path(), disk, machine, last);
    keeper.stopped_cleanly();
    settle(disk);
    ASSERT_TRUE(next_start_arms());
    refuse();
    keeper.remember_latch(control::Reason::kEmergencyStop);
  }
  EXPECT_FALSE(next_start_arms());
}

}  // namespace
}  // namespace hedgehog::server
