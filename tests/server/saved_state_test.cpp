// SPDX-License-Identifier: MIT
#include "daemon/server/disk/saved_state.h"
#include "base/atomic_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "daemon/control/state/state_machine.h"
#include "daemon/daemon.h"
#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/history/trip_recordings.h"
#include "model/thermal/thermal_flow.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBoot = "8f1c2a30-0000-4000-8000-000000000001";

SavedState hot() {
  SavedState s;
  s.saved_at = {kBoot, 1000.0};
  s.heat = {{50.0, 60.0, 55.0}, 45.0};
  s.ambient_c = 25.0;
  s.heat_known = true;
  s.measured = {false, true, false};
  s.latch = control::Reason::kSensorFrozen;
  s.rearms[static_cast<std::size_t>(control::Reason::kSensorFrozen)] = 4;
  s.gain = 0.5;
  return s;
}

TEST(SavedState, IsRestoredUnchanged) {
  const auto read = decode_saved_state(encode(hot()));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->heat.winding_c, hot().heat.winding_c);
  EXPECT_EQ(read->latch, control::Reason::kSensorFrozen);
  EXPECT_EQ(read->gain, 0.5);
  EXPECT_TRUE(read->heat_known);
  EXPECT_EQ(read->measured, hot().measured);
  EXPECT_EQ(read->saved_at, hot().saved_at);
  EXPECT_EQ(read->rearms, hot().rearms);
}

TEST(SavedState, ImpossibleValuesAreRejected) {
  EXPECT_FALSE(decode_saved_state(""));
  EXPECT_FALSE(decode_saved_state("{}"));
  EXPECT_FALSE(decode_saved_state(encode(hot()).substr(0, 60)));
  SavedState impossible = hot();
  impossible.heat.winding_c[1] = 900.0;
  EXPECT_FALSE(decode_saved_state(encode(impossible)));
  impossible = hot();
  impossible.gain = 7.0;
  EXPECT_FALSE(decode_saved_state(encode(impossible)));
  EXPECT_FALSE(decode_saved_state(encode(hot()) + '\0' + "garbage")) << "a NUL ends no file";
}

/// The hottest node of a real ball that starts at `now`, after hot().
double hottest_at(const BootTime& now) {
  config::Config real;
  real.backend = config::Backend::kUsb;
  return model::hottest_winding(daemon::start_state(real, hot(), now).settings.start);
}

TEST(StartState, OnlyTheClockOfTheBootCreditsCooling) {
  EXPECT_LT(hottest_at({kBoot, 1060.0}), 57.0);
  EXPECT_EQ(hottest_at({kBoot, 1000.0}), 60.0);
  EXPECT_EQ(hottest_at({kBoot, 400.0}), 60.0) << "a virtual machine that was put back";
  EXPECT_EQ(hottest_at({"", 90000.0}), 60.0) << "a kernel without a boot id";
  SavedState of_day = hot();
  of_day.saved_at = {};
  config::Config real;
  real.backend = config::Backend::kUsb;
  const auto start = daemon::start_state(real, of_day, {kBoot, 90000.0}).settings.start;
  EXPECT_EQ(start.winding_c, hot().heat.winding_c) << "a file without boot id";
}

TEST(StartState, AfterARebootOnlyTheTimeSinceItCounts) {
  const char* other = "8f1c2a30-0000-4000-8000-000000000002";
  EXPECT_EQ(hottest_at({other, 0.0}), 60.0);
  EXPECT_NEAR(hottest_at({other, 60.0}), hottest_at({kBoot, 1060.0}), 1e-9);
  EXPECT_LT(hottest_at({other, 40.0}), 60.0) << "later than 1000 s of the boot before";
}

TEST(BootTime, IsOfThisBootAndIncreases) {
  const BootTime first = boot_time_now();
  const BootTime second = boot_time_now();
  EXPECT_EQ(first.boot_id.size(), 36u);
  EXPECT_EQ(first.boot_id, second.boot_id);
  EXPECT_GT(first.seconds, 0.0);
  EXPECT_GE(seconds_between(first, second), 0.0);
  EXPECT_EQ(seconds_between(second, {first.boot_id, 0.0}), 0.0);
}

TEST(StartState, WithAMissingOrDamagedFileTheHeatOfARealBallIsUnknown) {
  config::Config real;
  real.backend = config::Backend::kUsb;
  EXPECT_FALSE(daemon::start_state(real, std::nullopt, BootTime{}).settings.start_known);
  EXPECT_FALSE(daemon::start_state(real, SavedState{}, BootTime{}).settings.start_known);
  config::Config simulator;
  EXPECT_FALSE(daemon::start_state(simulator, SavedState{}, BootTime{}).settings.start_known);
  EXPECT_TRUE(daemon::start_state(simulator, std::nullopt, BootTime{}).settings.start_known);
  config::Config measured = real;
  measured.device.uncertainty.thermal = 0.06;
  EXPECT_EQ(daemon::start_state(measured, std::nullopt, BootTime{}).settings.uncertainty.thermal,
            0.06);
  const auto warm = daemon::start_state(real, hot(), BootTime{kBoot, 1010.0}).settings;
  EXPECT_TRUE(warm.start_known);
  EXPECT_GT(warm.start.winding_c[1], 55.0);
  EXPECT_EQ(warm.start_measured, hot().measured);
  EXPECT_EQ(warm.rearms, hot().rearms);
}

TEST(StartState, HasTheUncertaintyOfItsCoolingConstants) {
  const auto deviation_k = [](double thermal, double seconds) {
    config::Config real;
    real.backend = config::Backend::kUsb;
    real.device.uncertainty.thermal = thermal;
    return daemon::start_state(real, hot(), BootTime{kBoot, 1000.0 + seconds})
        .settings.start_deviation_k;
  };
  const double rested_k = control::ControlSettings{}.start_deviation_k;
  EXPECT_EQ(deviation_k(0.2, 0.0), rested_k);
  EXPECT_GT(deviation_k(0.2, 600.0), rested_k + 1.0);
  EXPECT_NEAR(deviation_k(0.4, 600.0) - rested_k, 2.0 * (deviation_k(0.2, 600.0) - rested_k), 1e-9);
  EXPECT_NEAR(deviation_k(0.05, 600.0) - rested_k, (deviation_k(0.2, 600.0) - rested_k) / 4.0,
              1e-9);
}

TEST(StartState, ALostStateStartsTrippedAndUnknown) {
  for (const config::Backend backend : {config::Backend::kSimulator, config::Backend::kUsb}) {
    config::Config config;
    config.backend = backend;
    const auto settings = daemon::start_state(config, lost_state(), BootTime{}).settings;
    EXPECT_EQ(settings.latch, control::Reason::kStateLost);
    EXPECT_FALSE(settings.start_known);
    EXPECT_EQ(settings.start_measured, (std::array<bool, model::kCoils>{}));
  }
}

TEST(StartState, ASimulatedBallIsNeverAHotPlug) {
  config::Config config;
  config.backend = config::Backend::kUsb;
  EXPECT_EQ(daemon::start_state(config, std::nullopt, BootTime{}).settings.start_timeout, 10'000);
  config.backend = config::Backend::kSimulator;
  const control::ControlSettings settings =
      daemon::start_state(config, std::nullopt, BootTime{}).settings;
  control::StateMachine states{settings};
  device::BoardTelemetry board;
  board.mode = device::BoardMode::kReady;
  states.board_alive(board, 60'000);
  board.arm_count = 1;
  states.step(board, true, control::Reason::kNone, 60'000);
  states.step(board, true, control::Reason::kNone, 60'001);
  EXPECT_TRUE(states.armed());
}

TEST(StartState, ArmsARealBallOnlyAfterACleanStop) {
  config::Config real;
  real.backend = config::Backend::kUsb;
  SavedState last = hot();
  last.latch = control::Reason::kNone;
  EXPECT_FALSE(daemon::start_state(real, std::nullopt, BootTime{}).settings.arm_at_start);
  EXPECT_EQ(daemon::start_state(real, std::nullopt, BootTime{}).settings.start_reason,
            control::Reason::kNeverArmed);
  EXPECT_FALSE(daemon::start_state(real, last, BootTime{}).settings.arm_at_start);
  EXPECT_EQ(daemon::start_state(real, last, BootTime{}).settings.start_reason,
            control::Reason::kUncleanStop);
  last.clean_stop = true;
  EXPECT_TRUE(daemon::start_state(real, last, BootTime{}).settings.arm_at_start);
  real.arm_at_start = config::ArmAtStart::kNever;
  EXPECT_FALSE(daemon::start_state(real, last, BootTime{}).settings.arm_at_start);
  EXPECT_EQ(daemon::start_state(real, hot(), BootTime{}).settings.latch,
            control::Reason::kSensorFrozen);
}

TEST(Disk, AFileIsReplacedAtomically) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/state.json";
  EXPECT_EQ(base::write_file_atomically(path, "one"), "");
  EXPECT_EQ(base::write_file_atomically(path, "two"), "");
  std::string text;
  std::getline(std::ifstream(path), text);
  EXPECT_EQ(text, "two");
  EXPECT_FALSE(fs::exists(path + ".new"));
  EXPECT_NE(base::write_file_atomically(folder.path() + "/no/such/folder", "x"), "");
}

TEST(Disk, TheThreadFinishesItsQueueBeforeItEnds) {
  int done = 0;
  {
    DiskThread disk;
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(disk.post(DiskUse::kSafety, [&done] { ++done; }));
  }
  EXPECT_EQ(done, 10);
}

TEST(TripRecordings, ANumberOfTheHistoryIsNeverReused) {
  const TemporaryFolder folder;
  std::ofstream(recording_path(folder.path(), 1)) << "x";
  control::FlightRecorder recorder;
  DiskThread disk;
  TripRecordings recordings(folder.path(), disk, recorder, 2);
  EXPECT_TRUE(recordings.has(1));
  EXPECT_FALSE(recordings.has(2)) << "named when it could not be written";
  EXPECT_EQ(recordings.tripped(), 3u);
  EXPECT_EQ(TripRecordings(folder.path(), disk, recorder, 0).tripped(), 2u);
  EXPECT_EQ(recording_name(17), "trip-0017");
  EXPECT_EQ(recording_number("trip-0017"), 17u);
  EXPECT_EQ(recording_number("trip-12345"), 12345u);
  for (const char* wrong : {"", "trip-", "trip-1x", "trip-99999999999", "../trip-0001"})
    EXPECT_EQ(recording_number(wrong), 0u) << wrong;
}

TEST(TripRecordings, AreNumberedConsecutivelyAndTheOldestAreRemoved) {
  const TemporaryFolder folder;
  const auto make = [&](const char* name, int bytes) {
    std::ofstream(folder.path() + "/" + name) << std::string(static_cast<std::size_t>(bytes), 'x');
  };
  EXPECT_EQ(last_recording(folder.path()), 0u);
  make("trip-0007.hhr", 10);
  make("trip-0008.hhr", 10);
  make("trip-0009.hhr", 10);
  make("other.hhr", 1000);
  EXPECT_EQ(last_recording(folder.path()), 9u);
  EXPECT_EQ(recording_path(folder.path(), 10), folder.path() + "/trip-0010.hhr");
  prune_recordings(folder.path(), 2, 1000);
  EXPECT_FALSE(fs::exists(folder.path() + "/trip-0007.hhr"));
  EXPECT_TRUE(fs::exists(folder.path() + "/trip-0008.hhr"));
  prune_recordings(folder.path(), 50, 15);
  EXPECT_FALSE(fs::exists(folder.path() + "/trip-0008.hhr"));
  EXPECT_TRUE(fs::exists(folder.path() + "/trip-0009.hhr"));
  EXPECT_TRUE(fs::exists(folder.path() + "/other.hhr"));
}

}  // namespace
}  // namespace hedgehog::server
