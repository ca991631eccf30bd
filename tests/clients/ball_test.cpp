// SPDX-License-Identifier: MIT
// The client for games, against a daemon scripted by each test.
#include "clients/lib/ball.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <cmath>
#include <limits>

#include "clients/lib/threaded_ball.h"
#include "tests/clients/fake_daemon.h"

namespace hedgehog {
namespace {

using namespace std::chrono_literals;
using client::Failure;
using client::FakeDaemon;
using client::FakePeer;
using client::kLongTimeout;
using client::Notification;
using client::SilentPort;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kWelcome =
    R"({"jsonrpc":"2.0","id":1,"result":{"server":"fake","protocol":"1.0","role":"play",)"
    R"("limits":{"current_a":15.0,"continuous_a":5.0,"felt_a":2.1}}})";
constexpr const char* kArmedEvent =
    R"({"jsonrpc":"2.0","method":"event","params":{"type":"armed","time_ns":7}})";

BallOptions long_timeout() { return {.name = "test", .timeout = kLongTimeout}; }

/// Runs a frame loop until the condition holds. The test's timeout ends a loop that never gets
/// there.
template <class Until>
void frames(Ball& ball, Until until) {
  do {
    ball.update();
    std::this_thread::yield();
  } while (!until());
}

TEST(Ball, ConnectsWhileFramesGoOn) {
  std::string rumbled;
  FakeDaemon daemon([&](FakePeer& peer) {
    EXPECT_THAT(peer.read(), HasSubstr(R"("method":"hello","params":{"client":"test")"));
    peer.send_line(kWelcome);
    rumbled = peer.read();
  });
  Ball ball({SilentPort().address(), daemon.address()}, long_timeout());
  EXPECT_FALSE(ball.rumble("engine", 0.5)) << "nobody is there yet";
  frames(ball, [&] { return ball.connected(); });
  EXPECT_EQ(ball.hello().limits.felt_a, 2.1);
  EXPECT_EQ(ball.address(), daemon.address()) << "the first that answers";
  EXPECT_TRUE(ball.rumble("engine", 0.5, protocol::Word::kBack, {.frequency_hz = 70.0}));
  daemon.finish();
  EXPECT_THAT(rumbled, HasSubstr(R"("slot":"engine")"));
  EXPECT_THAT(rumbled, HasSubstr(R"("level":0.57)"));
  EXPECT_THAT(rumbled, HasSubstr(R"("lease_ms":250)"));
  EXPECT_THAT(rumbled, testing::Not(HasSubstr("\"id\"")));
}

TEST(Ball, ReportsThatTheDaemonDoesNotRun) {
  const SilentPort silent;
  Ball ball({silent.address()}, long_timeout());
  frames(ball, [&] { return !ball.problem().empty(); });
  EXPECT_EQ(ball.problem(),
            "the daemon does not run: " + to_string(silent.address()) + ": connection refused");
  EXPECT_FALSE(ball.connected());
  EXPECT_GT(ball.retry_after(), 0ms);
  const auto retried = ball.call(protocol::Ping{});
  ASSERT_FALSE(retried.has_value());
  EXPECT_EQ(retried.error().failure, Failure::kNoDaemon);
}

TEST(Ball, ItsDescriptorIsReadableWhenAMessageHasArrived) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.read();
    peer.send_line(kArmedEvent);
    EXPECT_EQ(peer.read(), "") << "the client has closed";
  });
  Ball ball({daemon.address()}, long_timeout());
  EXPECT_EQ(ball.descriptor(), -1);
  frames(ball, [&] { return ball.connected(); });
  ASSERT_TRUE(ball.notify(protocol::Ping{}));
  pollfd readable{ball.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&readable, 1, static_cast<int>(kLongTimeout.count())), 1);
  ball.update();
  EXPECT_TRUE(ball.next().has_value());
}

TEST(Ball, EndsAConnectionWithoutAResponseToHello) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    EXPECT_EQ(peer.read(), "") << "the client has closed";
  });
  Ball ball({daemon.address()}, {.name = "test", .timeout = 50ms});
  frames(ball, [&] { return !ball.problem().empty(); });
  EXPECT_THAT(ball.problem(), HasSubstr("no response within 0.1 s"));
}

TEST(Ball, ResponsesArriveAFewFramesLater) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.read();
    peer.send_line(kArmedEvent);
    peer.send_line(R"({"jsonrpc":"2.0","id":2,"result":{"time_ns":42}})");
    peer.read();
  });
  Ball ball({daemon.address()}, long_timeout());
  frames(ball, [&] { return ball.connected(); });
  const auto id = ball.request(protocol::Ping{});
  std::optional<protocol::Reply> reply;
  frames(ball, [&] { return (reply = ball.response()).has_value(); });
  EXPECT_EQ(reply->id, id);
  const auto event = ball.next();
  ASSERT_TRUE(event.has_value());
  EXPECT_EQ(std::get<protocol::EventMessage>(*event).event.time_ns, 7);
  EXPECT_FALSE(ball.next().has_value());
}

TEST(Ball, ResponsesEndWithTheirConnectionBecauseTheNextOneNumbersAnew) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.read();
    peer.send_line(R"({"jsonrpc":"2.0","id":2,"result":{"time_ns":42}})");
  });
  Ball ball({daemon.address()}, long_timeout());
  frames(ball, [&] { return ball.connected(); });
  ball.request(protocol::Ping{});
  frames(ball, [&] { return !ball.connected(); });
  EXPECT_FALSE(ball.response().has_value());
}

TEST(Ball, ReportsTheDaemonsErrorAboutTheConnection) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(
        R"({"jsonrpc":"2.0","id":null,"error":{"code":-32001,"message":"64 are connected"}})");
  });
  Ball ball({daemon.address()}, long_timeout());
  const auto opened = ball.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().message,
            "the connection to the daemon has ended: the daemon closed the connection "
            "(message: 64 are connected)");
}

TEST(Ball, ARequestThatIsTooLongDoesNotEndTheConnection) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.read();
    peer.send_line(R"({"jsonrpc":"2.0","id":3,"result":{"time_ns":42}})");
    peer.read();
  });
  Ball ball({daemon.address()}, long_timeout());
  const auto refused = ball.call_raw("ping", "{\"x\":\"" + std::string(70'000, 'x') + "\"}");
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, StartsWith("the request is longer than 64 KiB"));
  EXPECT_EQ(ball.call(protocol::Ping{}).value().time_ns, 42);
}

/// Accepts a subscription to events, and closes.
void accept_events(FakePeer& peer) {
  peer.read();
  peer.send_line(kWelcome);
  EXPECT_THAT(peer.read(), HasSubstr("events.subscribe"));
  peer.send_line(R"({"jsonrpc":"2.0","id":2,"result":{"types":[]}})");
}

/// Rejects the renewed subscription, and continues.
void reject_events(FakePeer& peer) {
  peer.read();
  peer.send_line(kWelcome);
  EXPECT_THAT(peer.read(), HasSubstr("events.subscribe"));
  peer.send_line(
      R"({"jsonrpc":"2.0","id":2,"error":{"code":-32004,"message":"forbidden: not any more"}})");
  EXPECT_THAT(peer.read(), HasSubstr("ping"));
  peer.send_line(R"({"jsonrpc":"2.0","id":3,"result":{"time_ns":42}})");
  peer.read();
}

TEST(Ball, ReportsASubscriptionThatTheNextDaemonRefuses) {
  FakeDaemon first(accept_events);
  FakeDaemon second(reject_events);
  Ball ball({first.address(), second.address()}, long_timeout());
  ASSERT_TRUE(ball.call_raw("events.subscribe", ""));
  first.finish();
  frames(ball, [&] { return ball.connections() == 2; });
  std::optional<client::ClientError> refused;
  frames(ball, [&] { return (refused = ball.refused_renewal()).has_value(); });
  EXPECT_EQ(refused->failure, Failure::kRefused);
  EXPECT_EQ(refused->message, "events.subscribe: forbidden: not any more");
  EXPECT_EQ(refused->refusal->code, protocol::ErrorCode::kForbidden);
  EXPECT_FALSE(ball.refused_renewal().has_value()) << "once";
  EXPECT_FALSE(ball.response().has_value()) << "nobody asked for that response";
  EXPECT_EQ(ball.call(protocol::Ping{}).value().time_ns, 42) << "the connection goes on";
}

TEST(ThreadedBall, ReportsASubscriptionThatTheNextDaemonRefuses) {
  FakeDaemon first(accept_events);
  FakeDaemon second(reject_events);
  ThreadedBall ball({first.address(), second.address()}, long_timeout());
  ASSERT_TRUE(ball.call_raw("events.subscribe", "").get());
  first.finish();
  std::optional<client::ClientError> refused;
  while (!(refused = ball.refused_renewal())) std::this_thread::yield();
  EXPECT_EQ(refused->message, "events.subscribe: forbidden: not any more");
  while (!ball.call(protocol::Ping{}).get()) std::this_thread::yield();
}

TEST(Ball, FeltLevelBeginsWhereAPushIsFelt) {
  const protocol::HelloLimits limits{.current_a = 15.0, .felt_a = 2.1};
  EXPECT_EQ(felt_level(0.0, limits), 0.0);
  EXPECT_EQ(felt_level(std::numeric_limits<double>::quiet_NaN(), limits), 0.0);
  EXPECT_NEAR(felt_level(1e-9, limits), 0.14, 1e-6);
  EXPECT_EQ(felt_level(7.0, limits), 1.0);
}

TEST(ThreadedBall, PlaysFromAnyThreadWithoutWaiting) {
  std::vector<std::string> lines;
  FakeDaemon daemon([&](FakePeer& peer) {
    peer.read();
    peer.send_line(kWelcome);
    peer.send_line(kArmedEvent);
    lines.push_back(peer.read());
    peer.send_line(R"({"jsonrpc":"2.0","id":2,"result":{"time_ns":42}})");
    lines.push_back(peer.read());
    lines.push_back(peer.read());
  });
  {
    ThreadedBall ball({daemon.address()}, long_timeout());
    EXPECT_EQ(ball.call(protocol::Ping{}).get().value().time_ns, 42);
    while (!ball.connected()) std::this_thread::yield();
    EXPECT_TRUE(ball.rumble("engine", 1.0));
    EXPECT_TRUE(ball.notify(protocol::EffectStopAll{}));
    EXPECT_EQ(ball.problem(), "");
    std::optional<Notification> event;
    while (!(event = ball.next())) std::this_thread::yield();
    EXPECT_TRUE(std::holds_alternative<protocol::EventMessage>(*event));
  }
  daemon.finish();
  EXPECT_THAT(lines, testing::ElementsAre(HasSubstr("ping"), HasSubstr("effect.vibrate"),
                                          HasSubstr("effect.stop_all")));
}

TEST(ThreadedBall, EndsWithoutADaemon) {
  const SilentPort silent;
  ThreadedBall ball({silent.address()}, long_timeout());
  while (ball.problem().empty()) std::this_thread::yield();
  EXPECT_FALSE(ball.rumble("engine", 1.0));
  EXPECT_EQ(ball.call(protocol::Ping{}).get().error().failure, Failure::kNoDaemon);
}

}  // namespace
}  // namespace hedgehog
