// SPDX-License-Identifier: MIT
// Evaluation of measurements by `hedgehogctl calibrate`, and the file that it writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/winding_bench.h"
#include "clients/ctl/calibrate/winding_fit.h"
#include "protocol/server_codec.h"
#include "tests/clients/fake_daemon.h"

namespace hedgehog::client {
namespace {

// Samples of a winding with the voltages of each millisecond, every fifth millisecond.
std::vector<WindingSample> driven(double r, double l, double frequency_hz, double offset_a) {
  std::vector<WindingSample> seen;
  const double decay = std::exp(-r * 1e-3 / l);
  double current_a = 0.0;
  for (int ms = 0; ms < 1400; ++ms) {
    const double t_s = 1e-3 * ms;
    const double v = 0.3 + 0.5 * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s);
    current_a = decay * current_a + (1.0 - decay) / r * v;
    if (ms >= 200 && ms % 5 == 0) seen.push_back({t_s, current_a + offset_a, v});
  }
  return seen;
}

RC_GTEST_PROP(WindingFit, FindsResistanceAndInductance, ()) {
  const double r = *rc::gen::inRange(20, 200) / 100.0;
  const double l = *rc::gen::inRange(30, 400) / 1e5;
  // a current that decays within the millisecond gives no information about L
  RC_PRE(std::exp(-r * 1e-3 / l) > 0.1);
  auto samples = driven(r, l, 47.0, 0.05);
  for (WindingSample& one : samples) one.current_a = std::round(1000.0 * one.current_a) / 1000.0;
  const auto found = sine_impedance(samples, 47.0);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(found->resistance_ohm / r - 1.0) < 0.02);
  RC_ASSERT(std::abs(found->inductance_h / l - 1.0) < 0.02);
}

TEST(WindingFit, AFewSamplesAtIrregularTimesAreFittedExactly) {
  const auto all = driven(0.9, 0.001, 47.0, 0.0);
  std::vector<WindingSample> few;
  for (std::size_t i = 0, gap = 1; i < all.size(); i += gap++) few.push_back(all[i]);
  ASSERT_LT(few.size(), kMinSamples + 3);
  const auto found = sine_impedance(few, 47.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->resistance_ohm, 0.9, 1e-9);
  EXPECT_NEAR(found->inductance_h, 0.001, 1e-12);
}

TEST(WindingFit, AConstantErrorOfTheSensorCancels) {
  const std::vector<WindingSample> forth(10, {0.0, 1.0 + 0.07, 0.45});
  const std::vector<WindingSample> back(10, {0.0, -1.0 + 0.07, -0.45});
  EXPECT_NEAR(*steady_resistance(forth, back), 0.45, 1e-9);
  EXPECT_LT(*steady_resistance(back, {10, {0.0, 2.0, -3.0}}), 1e9);
  EXPECT_FALSE(steady_resistance({}, back));
  EXPECT_FALSE(steady_resistance({{0, 0.015, 0.45}}, {{0, -0.015, -0.45}})) << "nothing flows";
}

TEST(WindingFit, TheErrorFollowsTheScatterOfTheCurrents) {
  std::vector<WindingSample> forth(100, {0.0, 1.0, 0.45});
  std::vector<WindingSample> back(100, {0.0, -1.0, -0.45});
  EXPECT_EQ(steady_resistance_error(forth, back), 0.0);
  for (std::size_t i = 0; i < forth.size(); ++i)
    forth[i].current_a = back[i].current_a = i % 2 == 0 ? 1.04 : 0.96;
  for (WindingSample& one : back) one.current_a -= 2.0;
  EXPECT_NEAR(steady_resistance_error(forth, back), 0.04 / 2.0 * std::sqrt(2.0 / 100.0), 5e-5);
}

TEST(WindingFit, TheErrorOfTheInductanceIsHowFarItScatters) {
  constexpr int kMeasurements = 400;
  std::mt19937 random(1);
  std::normal_distribution<double> noise_a(0.0, 0.02);
  std::normal_distribution<double> noise_v(0.0, 0.01);
  double squares = 0.0;
  double expected = 0.0;
  for (int i = 0; i < kMeasurements; ++i) {
    auto samples = driven(0.9, 0.001, 47.0, 0.0);
    samples.resize(40);
    for (WindingSample& one : samples) {
      one.current_a += noise_a(random);
      one.voltage_v += noise_v(random);
    }
    squares += std::pow(sine_impedance(samples, 47.0)->inductance_h / 0.001 - 1.0, 2.0);
    expected += std::pow(inductance_error(samples, 47.0), 2.0);
  }
  EXPECT_NEAR(std::sqrt(squares / expected), 1.0, 0.15);
  EXPECT_LT(inductance_error(driven(0.9, 0.001, 47.0, 0.0), 47.0), 1e-9);
  EXPECT_TRUE(std::isinf(inductance_error({}, 47.0)));
}

TEST(WindingFit, NoiseAndTooFewSamplesAreRejected) {
  EXPECT_FALSE(sine_impedance({}, 47.0));
  std::vector<WindingSample> flat(100, {0.0, 1.0, 0.45});
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i].t_s = 5e-3 * static_cast<double>(i);
  EXPECT_FALSE(sine_impedance(flat, 47.0));
}

TEST(Pushed, EachWindingOnAnAxisOfItsOwn) {
  const auto sides = read_pushed({"x=back", "y=up", "z=left"});
  ASSERT_TRUE(sides);
  const auto matrix = coil_matrix(*sides);
  ASSERT_TRUE(matrix);
  // Column by column: the currents for a field to the front, to the left, to the top.
  EXPECT_EQ((*matrix)[0], (model::Vec3{-1, 0, 0}));
  EXPECT_EQ((*matrix)[1], (model::Vec3{0, 0, 1}));
  EXPECT_EQ((*matrix)[2], (model::Vec3{0, 1, 0}));
  EXPECT_TRUE(read_pushed({}));
  EXPECT_FALSE(coil_matrix({}));
  for (const char* wrong : {"x=back", "x", "x=", "w=up", "x=sideways", "x:up"})
    EXPECT_FALSE(read_pushed({wrong})) << wrong;
  EXPECT_FALSE(read_pushed({"x=front", "y=back", "z=up"}));
}

TEST(Pushed, AnswersMayBeAbbreviated) {
  for (const char* answer : {"left", "Left", " l", "LE\r", "lef "})
    EXPECT_EQ(side_meant(answer), "left") << answer;
  for (const char* answer : {"", " ", "lft", "lefty", "x", "up down", "-"})
    EXPECT_EQ(side_meant(answer), "") << answer;
}

TEST(Pushed, TwoOnOneAxisAndLeftHandedAxesAreDetected) {
  EXPECT_EQ(same_axis({{"left", "front", "right"}}, 2), 0u);
  EXPECT_EQ(same_axis({{"left", "front", "up"}}, 2), std::nullopt);
  EXPECT_EQ(same_axis({{"left", "", ""}}, 0), std::nullopt);
  EXPECT_FALSE(is_left_handed({{"front", "left", "up"}}));
  EXPECT_FALSE(is_left_handed({{"left", "back", "up"}})) << "only turned";
  EXPECT_TRUE(is_left_handed({{"left", "front", "up"}})) << "two swapped";
  EXPECT_TRUE(is_left_handed({{"front", "left", "down"}})) << "one turned";
  EXPECT_FALSE(is_left_handed({}));
}

TEST(WindingProblem, IsNamedWithARemedy) {
  using testing::HasSubstr;
  constexpr std::array<double, 3> kForth{0.3, 0.04, 0.0};
  constexpr std::array<double, 3> kBack{-0.3, 0.04, 0.0};
  EXPECT_EQ(winding_problem(0, kForth, kBack, 0.45), "") << "a sensor's constant error is none";
  EXPECT_THAT(winding_problem(1, kForth, kBack, 4.0), HasSubstr("winding y: when it is driven"));
  EXPECT_THAT(winding_problem(1, kForth, kBack, 4.0), HasSubstr("measured in x; compare"));
  EXPECT_THAT(winding_problem(2, {0.001, 0, 0}, {}, std::nullopt), HasSubstr("check its plug"));
  EXPECT_THAT(winding_problem(0, kBack, kForth, -0.45), HasSubstr("other way round"));
  EXPECT_THAT(winding_problem(0, kForth, kBack, 0.04), HasSubstr("0.04 ohm"));
}

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
