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

}  // namespace
}  // namespace hedgehog::server
