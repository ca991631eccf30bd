// SPDX-License-Identifier: MIT
// A state file that is damaged or of another ball clears no latch.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "daemon/server/device/device_view.h"
#include "daemon/server/device/file_state_store.h"
#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/load_saved_state.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

using control::Reason;

/// A state directory with one file in it.
struct LostState : testing::Test {
  std::optional<SavedState> load(const std::string& text) const {
    std::ofstream(folder.path("state.json"), std::ios::binary) << text;
    return load_saved_state(folder.path(), ball);
  }
  Reason latch_of(const std::string& text) const {
    const auto state = load(text);
    return state ? state->latch : Reason::kNone;
  }
  std::string of(const BallIdentity& identity) const {
    SavedState state;
    state.heat_known = true;
    state.clean_stop = true;
    state.ball = identity;
    return encode(state);
  }

  const TemporaryFolder folder;
  BallIdentity ball{false, "B7"};
};

TEST_F(LostState, AMissingFileIsAFirstStart) {
  EXPECT_FALSE(load_saved_state(folder.path(), ball));
}

TEST_F(LostState, APartialFirstWriteIsNone) {
  std::ofstream(folder.path("state.json.new")) << "{";
  EXPECT_EQ(load_saved_state(folder.path(), ball)->latch, Reason::kStateLost);
}

TEST_F(LostState, AFileDamagedAnywhereCountsAsALatch) {
  const std::string good = of(ball);
  EXPECT_EQ(latch_of(good), Reason::kNone);
  EXPECT_EQ(latch_of(""), Reason::kStateLost);
  EXPECT_EQ(latch_of("{}"), Reason::kStateLost);
  EXPECT_EQ(latch_of(R"({"version":2})"), Reason::kStateLost) << "of another version";
  EXPECT_EQ(latch_of(std::string(good.size(), '\0')), Reason::kStateLost);
  std::filesystem::remove(folder.path("state.json"));
  std::filesystem::create_directory(folder.path("state.json"));
  EXPECT_EQ(load_saved_state(folder.path(), ball)->latch, Reason::kStateLost);
}

TEST_F(LostState, AFileTruncatedAnywhereCountsAsALatch) {
  const std::string good = of(ball);
  for (std::size_t left = 0; left + 2 < good.size(); ++left)
    ASSERT_EQ(latch_of(good.substr(0, left)), Reason::kStateLost) << left;
}

TEST_F(LostState, AFileOfAnotherBallCountsAsALatch) {
  EXPECT_EQ(latch_of(of({false, "B8"})), Reason::kStateLost);
  EXPECT_FALSE(load(of({false, "B8"}))->heat_known);
  EXPECT_EQ(latch_of(of({true, ""})), Reason::kStateLost) << "of the simulator";
  EXPECT_EQ(latch_of(of({false, ""})), Reason::kNone) << "a board that does not say which";
  ball.serial.clear();
  EXPECT_EQ(latch_of(of({false, "B8"})), Reason::kNone) << "compared when the board is there";
  ball.simulated = true;
  EXPECT_FALSE(load(of({false, "B8"}))) << "the simulated ball is another one";
}

/// The state of ball B7, and a board with a serial number of its own.
struct OtherBall : LostState {
  void SetUp() override {
    config.backend = config::Backend::kUsb;
    last.ball = ball;
    last.heat_known = true;
    snapshot.tick = 1;
    snapshot.board_present = snapshot.sensor_valid = true;
    mailbox->status.write(snapshot);
  }
  /// True if control is requested to forget the ball when the board reports `serial`.
  bool is_reset(const std::optional<std::string>& serial) {
    DeviceView device_view(config, *mailbox, *port, 0);
    device_view.set_board_info_source([&] { return BoardInfo{{}, serial, {}}; });
    {
      DiskThread disk;
      FileStateStore store(folder.path(), disk, device_view, last);
      store.pump();
      store.pump();
    }
    std::array<control::Command, control::kMaxCommandsPerTick> commands;
    const auto taken = mailbox->commands.pop(commands.data(), commands.size());
    EXPECT_LE(taken, 1u) << "asked once";
    return taken == 1 && std::holds_alternative<control::ResetBall>(commands[0].what);
  }

  config::Config config;
  SavedState last;
  control::StatusSnapshot snapshot;
  std::unique_ptr<control::Mailbox> mailbox = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
};

TEST_F(OtherBall, IsDetectedByItsBoard) {
  EXPECT_FALSE(is_reset("B7"));
  EXPECT_FALSE(is_reset(std::nullopt));
  EXPECT_TRUE(is_reset("B8"));
  EXPECT_EQ(load_saved_state(folder.path())->ball, (BallIdentity{false, "B8"}));
}

}  // namespace
}  // namespace hedgehog::server
