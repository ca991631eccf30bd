// SPDX-License-Identifier: MIT
// The state file when the disk is slower than the daemon, or fails.
#include "daemon/server/device/file_state_store.h"
#include "base/atomic_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>

#include "daemon/daemon.h"
#include "daemon/server/device/device_view.h"
#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/load_saved_state.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

TEST(FileStateStore, TheOrderlyStopIsWrittenLast) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("hedgehog-state-keeper-test-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  control::StatusSnapshot snapshot;
  snapshot.tick = 1;
  mailbox->status.write(snapshot);
  DeviceView device_view(config::Config{}, *mailbox, *port, 0);
  std::promise<void> slow;
  {
    DiskThread disk;
    ASSERT_TRUE(disk.post(DiskUse::kSafety, [wait = slow.get_future().share()] { wait.wait(); }));
    FileStateStore store(folder.string(), disk, device_view, std::nullopt);
    store.persist_gain(0.5);
    store.pump();  // queued behind the slow job
    store.stopped_cleanly();
    slow.set_value();
  }
  const auto state = load_saved_state(folder.string());
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->clean_stop);
  EXPECT_EQ(state->gain, 0.5);
}

TEST(FileStateStore, TheHeatOfTheLastRunIsKeptUntilTheFirstReading) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("hedgehog-state-keeper-heat-test-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  SavedState last;
  last.saved_at = {"another boot", 1000.0};
  last.heat_known = true;
  last.heat = {{55.0, 56.0, 57.0}, 50.0};
  last.ambient_c = 21.0;
  control::StatusSnapshot snapshot;
  snapshot.tick = 1;
  mailbox->status.write(snapshot);
  DeviceView device_view(config::Config{}, *mailbox, *port, 0);
  const auto after = [&](auto&& what) {
    {
      DiskThread disk;
      FileStateStore store(folder.string(), disk, device_view, last);
      what(store);
      store.stopped_cleanly();
    }
    return load_saved_state(folder.string()).value_or(SavedState{});
  };
  const SavedState without_board = after([](FileStateStore& store) {
    store.persist_latch(control::Reason::kEmergencyStop);
    store.pump();
  });
  EXPECT_TRUE(without_board.heat_known);
  EXPECT_EQ(without_board.heat.winding_c, last.heat.winding_c);
  EXPECT_EQ(without_board.saved_at, last.saved_at) << "it has cooled since then, not since now";
  EXPECT_EQ(without_board.latch, control::Reason::kEmergencyStop);

  snapshot.board_present = true;
  snapshot.sensor_valid = true;
  snapshot.thermal.nodes = {{31.0, 31.0, 31.0}, 30.0};
  snapshot.thermal.measured = {false, true, false};
  mailbox->status.write(snapshot);
  device_view.refresh();
  const SavedState with_board = after([](FileStateStore& store) { store.pump(); });
  std::filesystem::remove_all(folder);
  EXPECT_EQ(with_board.heat.winding_c, snapshot.thermal.nodes.winding_c);
  EXPECT_TRUE(with_board.heat_known);
  EXPECT_EQ(with_board.measured, snapshot.thermal.measured);
  EXPECT_EQ(with_board.saved_at.boot_id, boot_time_now().boot_id);
}

TEST(FileStateStore, R25OfEachStartIsKeptAndCounted) {
  const TemporaryFolder folder;
  const auto mailbox = std::make_unique<control::Mailbox>();
  const auto port = std::make_unique<device::LinkPort>();
  DeviceView device_view(config::Config{}, *mailbox, *port, 0);
  const auto run = [&](const std::array<double, model::kCoils>& r25_ohm) {
    control::StatusSnapshot snapshot;
    snapshot.tick = 1;
    snapshot.r25_ohm = r25_ohm;
    mailbox->status.write(snapshot);
    device_view.refresh();
    DiskThread disk;
    FileStateStore store(folder.path(), disk, device_view, load_saved_state(folder.path()));
    store.pump();
    store.pump();
  };
  const auto kept = [&] { return load_saved_state(folder.path())->r25; };
  run({0.45, 0.0, 0.44});
  EXPECT_EQ(kept(), (std::array<R25History, 3>{{{0.45, 1}, {0.0, 0}, {0.44, 1}}}));
  EXPECT_FALSE(device_view.r25(0)->from_kept) << "none was kept before";
  run({0.468, 0.46, 0.0});
  EXPECT_EQ(kept(), (std::array<R25History, 3>{{{0.468, 2}, {0.46, 1}, {0.44, 1}}}));
  EXPECT_NEAR(*device_view.r25(0)->from_kept, 0.04, 1e-9);
  EXPECT_FALSE(device_view.r25(2));
}

/// A ball at rest, with a state file whose writes can be made to fail.
struct RefusingDisk : testing::Test {
  void SetUp() override {
    snapshot.tick = 1;
    exchange();
    last.clean_stop = true;
    ASSERT_EQ(base::write_file_atomically(folder.path("state.json"), encode(last)), "");
  }
  void exchange() {
    mailbox->status.write(snapshot);
    device_view.refresh();
  }
  /// Simulates a full disk: no file can be written beside the state file, which can be removed.
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
    const auto settings = daemon::start_state(real, on_disk(), BootTime{}).settings;
    return settings.arm_at_start && settings.latch == control::Reason::kNone;
  }

  const TemporaryFolder folder;
  std::unique_ptr<control::Mailbox> mailbox = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
  control::StatusSnapshot snapshot;
  DeviceView device_view{config::Config{}, *mailbox, *port, 0};
  SavedState last;
  std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
};

TEST_F(RefusingDisk, DoesNotKeepTheMarkOfTheLastOrderlyStop) {
  ASSERT_TRUE(next_start_arms());
  refuse();
  DiskThread disk;
  FileStateStore store(folder.path(), disk, device_view, last);
  EXPECT_FALSE(next_start_arms()) << "a kill from here on is no orderly stop";
  store.persist_latch(control::Reason::kEmergencyStop);
  store.stopped_cleanly();
  settle(disk);
  EXPECT_FALSE(next_start_arms());
}

TEST_F(RefusingDisk, IsRetriedEachSecondUntilTheLatchIsWritten) {
  DiskThread disk;
  FileStateStore store(folder.path(), disk, device_view, last);
  refuse();
  store.pump(now);
  snapshot.latch = control::Reason::kEmergencyStop;
  exchange();
  store.persist_latch(control::Reason::kEmergencyStop);
  settle(disk);
  store.pump(now += std::chrono::seconds(1));
  settle(disk);
  EXPECT_EQ(on_disk()->latch, control::Reason::kNone);
  EXPECT_FALSE(next_start_arms());
  allow();
  store.pump(now += std::chrono::milliseconds(900));
  settle(disk);
  EXPECT_EQ(on_disk()->latch, control::Reason::kNone) << "not as fast as it turns";
  store.pump(now += std::chrono::milliseconds(100));
  settle(disk);
  ASSERT_EQ(on_disk()->latch, control::Reason::kEmergencyStop);
  std::filesystem::remove(folder.path("state.json"));
  store.pump(now += std::chrono::seconds(5));
  settle(disk);
  EXPECT_FALSE(on_disk()) << "written again without need";
}

TEST_F(RefusingDisk, ReportsWhetherTheLatchIsOnDisk) {
  DiskThread disk;
  FileStateStore store(folder.path(), disk, device_view, last);
  std::promise<void> slow;
  ASSERT_TRUE(disk.post(DiskUse::kSafety, [wait = slow.get_future().share()] { wait.wait(); }));
  const std::uint64_t first = store.persist_latch(control::Reason::kEmergencyStop);
  EXPECT_EQ(store.latch_persisted(first), Persisted::kPending);
  slow.set_value();
  settle(disk);
  EXPECT_EQ(store.latch_persisted(first), Persisted::kYes);
  EXPECT_EQ(on_disk()->latch, control::Reason::kEmergencyStop);
  refuse();
  const std::uint64_t second = store.persist_latch(control::Reason::kEmergencyStop);
  EXPECT_EQ(store.latch_persisted(first), Persisted::kYes)
      << "whoever asks again does not hold it up";
  settle(disk);
  EXPECT_EQ(store.latch_persisted(second), Persisted::kNo);
  allow();
  store.pump(now);
  settle(disk);
  EXPECT_EQ(store.latch_persisted(second), Persisted::kYes) << "asked again";
}

TEST_F(RefusingDisk, APartialFileOfAKillIsRemovedBesideAValidOne) {
  folder.write("state.json.new", "{");
  folder.write("state.json", encode(last));
  DiskThread disk;
  const FileStateStore store(folder.path(), disk, device_view, std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(folder.path("state.json.new")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("state.json")));
}

TEST_F(RefusingDisk, DoesNotKeepAnOrderlyStopBeforeAnEmergencyStop) {
  {
    DiskThread disk;
    FileStateStore store(folder.path(), disk, device_view, last);
    store.stopped_cleanly();
    settle(disk);
    ASSERT_TRUE(next_start_arms());
    refuse();
    store.persist_latch(control::Reason::kEmergencyStop);
  }
  EXPECT_FALSE(next_start_arms());
}

}  // namespace
}  // namespace hedgehog::server
