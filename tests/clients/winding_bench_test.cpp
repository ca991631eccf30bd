// SPDX-License-Identifier: MIT
// How long `hedgehogctl calibrate` measures a winding, and what ends it before.
#include "clients/ctl/calibrate/winding_bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>

#include "clients/ctl/calibrate/winding_fit.h"
#include "protocol/server_codec.h"
#include "tests/clients/fake_daemon.h"

namespace hedgehog::client {
namespace {

/// A ball whose winding x carries 0.3 A, or a sine up to that, from 0.1 s after the request until
/// its lease or duration ends. Every request takes 0.15 s of device time.
struct FakeBall {
  std::int64_t every_ms = 5;
  double noise_a = 0.0;  // added and subtracted in turn
  double current_a = 0.3;
  std::string state = "armed";
  std::string reason = "none";

  void operator()(FakePeer& peer) const {
    std::int64_t now_ms = 1000;
    double frequency_hz = 0.0;
    std::int64_t flows_from_ms = 1'000'000;
    std::int64_t flows_until_ms = flows_from_ms;
    bool subscribed = false;
    const auto send_until = [&](std::int64_t until_ms) {
      for (; now_ms < until_ms; now_ms += every_ms) {
        if (!subscribed) continue;
        protocol::Status status;
        status.time_ns = 1'000'000 * now_ms;
        status.state = state;
        status.reason = reason;
        status.supply_v = 12.0;
        const double added_a = now_ms / every_ms % 2 == 0 ? noise_a : -noise_a;
        const bool flows = now_ms >= flows_from_ms && now_ms < flows_until_ms;
        const double phase =
            2.0 * std::numbers::pi * frequency_hz * 1e-3 * static_cast<double>(now_ms);
        const double share = frequency_hz > 0.0 ? 0.5 + 0.5 * std::sin(phase) : 1.0;
        status.current_a.x = flows ? share * current_a + added_a : 0.0;
        status.duty.x = flows ? 0.02 + 0.02 * std::sin(phase + 0.5) : 0.0;
        protocol::StatusKeys keys;
        for (const auto key : {protocol::StatusKey::kState, protocol::StatusKey::kReason,
                               protocol::StatusKey::kSupplyV, protocol::StatusKey::kCurrentA,
                               protocol::StatusKey::kDuty})
          keys.add(key);
        peer.send_line(protocol::encode_telemetry({keys, status}));
      }
    };
    for (std::string line; !(line = peer.read()).empty();) {
      const auto request = nlohmann::json::parse(line);
      const std::string method = request["method"];
      const protocol::Id id{request["id"].dump()};
      send_until(now_ms + 150);
      if (method == "ping") {
        peer.send_line(protocol::encode_result(id, protocol::PingResult{1'000'000 * now_ms}));
      } else if (method == "device.claim") {
        peer.send_line(protocol::encode_result(id, protocol::ClaimResult{}));
      } else if (method == "effect.hold" || method == "effect.vibrate") {
        const auto& params = request["params"];
        frequency_hz = params.value("frequency_hz", 0.0);
        flows_from_ms = now_ms + 100;
        flows_until_ms =
            flows_from_ms +
            params[method == "effect.hold" ? "lease_ms" : "duration_ms"].get<std::int64_t>();
        peer.send_line(protocol::encode_result(id, protocol::Admission{}));
        if (subscribed) send_until(now_ms + 150 * every_ms);
      } else if (method == "telemetry.subscribe") {
        subscribed = true;
        peer.send_line(protocol::encode_result(id, protocol::TelemetryResult{}));
        if (flows_from_ms < 1'000'000) send_until(now_ms + 150 * every_ms);
      } else if (method == "effect.stop_all") {
        subscribed = false;
        peer.send_line(protocol::encode_result(id, protocol::StopResult{}));
      } else {
        peer.send_line(protocol::encode_result(id, protocol::Done{}));
      }
    }
  }
};

/// Result of holding 0.3 A for 0.2 s, and the trip that occurred meanwhile.
struct Held {
  explicit Held(const FakeBall& ball, WindingBench::Extent extent = {0.2}) : daemon(ball) {
    Session session{Connection::open({daemon.address()}).value(), false, {}};
    WindingBench bench(session);
    record = bench.hold(0, 1.0, 0.3, extent);
    tripped = bench.tripped();
  }
  FakeDaemon daemon;
  Outcome<WindingRecord> record = WindingRecord{};
  std::optional<std::string> tripped;
};

TEST(WindingBench, CountsOnlyTelemetryAfterTheCurrentFlowed) {
  const Held held({.every_ms = 5});
  ASSERT_TRUE(held.record) << held.record.error().message;
  EXPECT_GE(held.record->samples.size(), 35u);
  EXPECT_DOUBLE_EQ(held.record->mean_a[0], 0.3);
}

TEST(WindingBench, ContinuesUntilItHasEnoughSamples) {
  const Held held({.every_ms = 100});
  ASSERT_TRUE(held.record) << held.record.error().message;
  EXPECT_EQ(held.record->samples.size(), 20u);
  EXPECT_DOUBLE_EQ(held.record->mean_a[0], 0.3);
}

TEST(WindingBench, ContinuesUntilTheMeanIsAccurate) {
  const Held held({.every_ms = 20, .noise_a = 0.03}, {0.2, 0.01});
  ASSERT_TRUE(held.record) << held.record.error().message;
  EXPECT_NEAR(static_cast<double>(held.record->samples.size()), 101.0, 2.0);
}

TEST(WindingBench, AWindingWithoutCurrentIsMeasuredNoLonger) {
  const Held held({.every_ms = 20, .current_a = 0.0}, {0.2, 0.01});
  ASSERT_TRUE(held.record) << held.record.error().message;
  EXPECT_LT(held.record->samples.size(), 30u);
}

TEST(WindingBench, ANoisyCurrentIsMeasuredForAsLongAsItFlows) {
  const Held held({.every_ms = 100, .noise_a = 0.2}, {0.2, 0.01});
  ASSERT_TRUE(held.record) << held.record.error().message;
  EXPECT_NEAR(held.record->mean_a[0], 0.3, 0.01) << "none after its lease";
  EXPECT_THAT(held.record->samples.size(), testing::AllOf(testing::Gt(80u), testing::Lt(100u)));
}

TEST(WindingBench, ASineIsMeasuredUntilTheInductanceIsAccurate) {
  constexpr double kMaxError = 0.02;
  FakeDaemon daemon(FakeBall{.every_ms = 20, .noise_a = 0.008});
  Session session{Connection::open({daemon.address()}).value(), false, {}};
  const auto record = WindingBench(session).sine(0, 0.3, 47.0, {0.2, kMaxError});
  ASSERT_TRUE(record) << record.error().message;
  auto samples = record->samples;
  EXPECT_GT(samples.size(), kMinSamples);
  EXPECT_LE(inductance_error(samples, 47.0), kMaxError);
  samples.pop_back();
  EXPECT_GT(inductance_error(samples, 47.0), kMaxError) << "and no longer";
}

TEST(WindingBench, TooLittleTelemetryIsNoOpenWinding) {
  const Held held({.every_ms = 600});
  ASSERT_FALSE(held.record);
  EXPECT_EQ(held.record.error().failure, Failure::kTimeout);
  EXPECT_THAT(held.record.error().message, testing::HasSubstr("telemetry rate too low"));
}

TEST(WindingBench, DistinguishesATripFromAnotherEnd) {
  const Held tripped({.state = "tripped", .reason = "current_mismatch"});
  EXPECT_FALSE(tripped.record);
  EXPECT_EQ(tripped.tripped, "current_mismatch");
  const Held stopped({.state = "disarmed", .reason = "emergency_stop"});
  EXPECT_FALSE(stopped.record);
  EXPECT_EQ(stopped.tripped, std::nullopt);
}

}  // namespace
}  // namespace hedgehog::client
