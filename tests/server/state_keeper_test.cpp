// SPDX-License-Identifier: MIT
// The state file when the disk is slower than the daemon.
#include "daemon/server/state_keeper.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <future>
#include <memory>

#include "daemon/server/disk_thread.h"
#include "daemon/server/machine.h"

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
    disk.post([wait = slow.get_future().share()] { wait.wait(); });
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

}  // namespace
}  // namespace hedgehog::server
