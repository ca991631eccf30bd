// SPDX-License-Identifier: MIT
// telemetry.history: contains what was played, is bounded, and persists across a restart.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "daemon/server/history/telemetry_file.h"
#include "daemon/server/history/telemetry_samples.h"
#include "protocol/server_codec.h"
#include "tests/server/server_rig.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

TEST(TelemetryHistory, HasWhatWasPlayed) {
  ServerRig rig;
  FakeClient& page = rig.connect(protocol::Role::kObserve);
  FakeClient& game = rig.connect();
  rig.run(3'000);
  rig.call(game, "effect.hold", {{"direction", "left"}, {"current_a", 5}, {"lease_ms", 3000}});
  rig.run(5'000);
  const Json history = rig.call(page, "telemetry.history", {{"seconds", 20}});
  EXPECT_EQ(history["step_s"], 1.0);
  const Json& samples = history["samples"];
  ASSERT_GE(samples.size(), 7u);
  double age_s = 100.0;
  double peak_a = 0.0;
  double hottest_c = 0.0;
  for (const Json& sample : samples) {
    EXPECT_LT(sample["age_s"], age_s) << "oldest first";
    age_s = sample["age_s"];
    peak_a = std::max(peak_a, sample["peak_a"].get<double>());
    hottest_c = std::max(hottest_c, sample["coils_c"][1].get<double>());
    EXPECT_LE(sample["current_a"], sample["peak_a"].get<double>() + 0.1);
    EXPECT_EQ(sample["limit_a"], 15.0);
  }
  EXPECT_NEAR(peak_a, 5.0, 0.3);
  EXPECT_GT(hottest_c, 25.5) << "that winding has warmed up";
  EXPECT_LT(samples.back()["age_s"], 1.1);
  EXPECT_LT(samples.back()["current_a"], 0.5) << "it has ended";
  EXPECT_EQ(rig.call(page, "telemetry.history", {{"seconds", 2}})["samples"].size(), 2u);
  EXPECT_EQ(rig.call(page, "telemetry.history", {{"seconds", 601}})["data"]["field"], "seconds");
}

TEST(TelemetryHistory, HasThePeakOfAPulseBetweenTwoPumps) {
  ServerRig rig;
  FakeClient& game = rig.connect();
  rig.run(2'000);
  rig.call(game, "effect.pulse", {{"direction", "left"}, {"current_a", 5}, {"duration_ms", 6}});
  rig.run_without_pump(15);
  EXPECT_LT(rig.plant_current_a(), 0.5) << "it has ended";
  rig.run(2'000);
  double peak_a = 0.0;
  const Json history = rig.call(game, "telemetry.history", {{"seconds", 4}});
  for (const Json& sample : history["samples"])
    peak_a = std::max(peak_a, sample["peak_a"].get<double>());
  EXPECT_GT(peak_a, 3.0);
}

TEST(TelemetryHistory, ALimitIsNeverAboveTheConfiguredOne) {
  for (const double configured_a : {7.777, 7.77, 7.78, 14.996, 15.0, 0.29, 0.07}) {
    TelemetrySamples samples;
    control::StatusSnapshot now;
    now.tick = TelemetrySamples::kPeriod;
    protocol::Status status;
    status.limit_a = configured_a;
    samples.add(now, status);
    const Json history = Json::parse(protocol::encode_value(samples.recent(10, now.tick, 0)));
    const double limit_a = history["samples"][0]["limit_a"];
    EXPECT_LE(limit_a, configured_a);
    EXPECT_GT(limit_a, configured_a - 0.00999);
    if (configured_a != 7.777 && configured_a != 14.996) EXPECT_EQ(limit_a, configured_a);
  }
}

/// `count` seconds of samples at 5 A.
struct Filled {
  explicit Filled(model::Tick count) {
    for (model::Tick second = 1; second <= count; ++second) {
      now.tick = second * TelemetrySamples::kPeriod;
      now.totals.heat_a2s += 25.0;
      now.totals.on_s.y += 0.25;
      status.temperature_c.model = 40.0;
      status.temperature_c.coils = {30.0, 40.0, 31.0};
      status.limit_a = 15.0;
      EXPECT_TRUE(samples.due(now.tick));
      samples.add(now, status);
      EXPECT_FALSE(samples.due(now.tick));
    }
  }
  protocol::TelemetryHistoryResult recent(double seconds) const {
    return samples.recent(seconds, now.tick, 0);
  }

  TelemetrySamples samples;
  control::StatusSnapshot now;
  protocol::Status status;
};

TEST(TelemetryHistory, IsBoundedAndAResponseFitsALine) {
  const Filled day(86'400);
  const auto all = day.recent(600);
  ASSERT_EQ(all.samples.size(), 200u);
  EXPECT_EQ(all.step_s, 3.0);
  EXPECT_NEAR(all.samples.front().age_s, 597.0, 3.0);
  EXPECT_NEAR(all.samples.front().current_a, 5.0, 1e-3);
  EXPECT_NEAR(all.samples.front().duty[1], 0.25, 1e-3);
  EXPECT_LT(protocol::encode_value(all).size(), 60'000u);
  EXPECT_EQ(day.recent(120).samples.size(), 120u);
}

TEST(TelemetryHistory, PersistsOverARestartWithTheGap) {
  const Filled before(100);
  const std::string encoded = before.samples.encoded(before.now.tick, 5'000'000);
  EXPECT_LT(encoded.size(), 64u * 1024);
  TelemetrySamples after;
  after.restore(encoded, 50, 5'000'000 + 30'000);
  const auto all = after.recent(600, 50, 0);
  ASSERT_EQ(all.samples.size(), before.recent(600).samples.size());
  EXPECT_NEAR(all.samples.back().age_s, before.recent(600).samples.back().age_s + 30.0, 0.01);
  EXPECT_EQ(all.samples.back().coils_c, before.recent(600).samples.back().coils_c);
}

TEST(TelemetryHistory, LeavesOutImpossibleValues) {
  const Filled before(10);
  const std::string encoded = before.samples.encoded(before.now.tick, 5'000'000);
  const auto restored = [](const std::string& bytes, std::int64_t unix_ms) {
    TelemetrySamples samples;
    samples.restore(bytes, 0, unix_ms);
    return samples.recent(600, 0, 0).samples.size();
  };
  EXPECT_GT(restored(encoded, 5'000'000), 0u);
  EXPECT_EQ(restored(encoded, 4'999'999), 0u) << "from the future: the clock was set back";
  EXPECT_EQ(restored(encoded, 5'000'000 + 3'600'000), 0u) << "too old";
  EXPECT_EQ(restored("", 5'000'000), 0u);
  EXPECT_EQ(restored(encoded.substr(0, encoded.size() - 1), 5'000'000), 0u) << "cut off";
  for (const std::size_t place : {std::size_t{0}, std::size_t{24}, encoded.size() - 3}) {
    std::string damaged = encoded;
    damaged[place] = static_cast<char>(damaged[place] + 1);
    EXPECT_EQ(restored(damaged, 5'000'000), 0u) << place;
  }
}

TEST(TelemetryHistory, LeavesOutUnknownValues) {
  TelemetrySamples samples;
  control::StatusSnapshot now;
  now.tick = 1000;
  samples.add(now, {});
  const auto all = samples.recent(10, 1000, 0);
  ASSERT_EQ(all.samples.size(), 1u);
  EXPECT_EQ(all.samples[0].coils_c, std::nullopt);
  EXPECT_EQ(all.samples[0].upper_c, std::nullopt);
  EXPECT_EQ(all.samples[0].sensor_c, std::nullopt);
  EXPECT_EQ(all.samples[0].headroom_s, std::nullopt);
}

TEST(TelemetryHistory, IsOnDiskAMinuteAfterACurrent) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_telemetry(folder.path()), "");
  Filled filled(10);
  {
    DiskThread disk;
    TelemetryFile file(folder.path(), disk);
    file.pump(filled.samples, filled.now.tick, 1'000);
    file.pump(filled.samples, filled.now.tick, 1'000 + TelemetryFile::kPeriodMs);
  }
  EXPECT_EQ(load_telemetry(folder.path()), "") << "nothing has flowed";
  {
    DiskThread disk;
    TelemetryFile file(folder.path(), disk);
    file.write(filled.samples, filled.now.tick, 2'000);
  }
  EXPECT_EQ(load_telemetry(folder.path()), filled.samples.encoded(filled.now.tick, 2'000));
}

}  // namespace
}  // namespace hedgehog::server
