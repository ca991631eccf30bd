// SPDX-License-Identifier: MIT
// The C++ client against a daemon scripted by each test.
#include "clients/lib/connection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/clients/fake_daemon.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr const char* kPong = R"({"jsonrpc":"2.0","id":1,"result":{"time_ns":42}})";
constexpr const char* kShutdown =
    R"({"jsonrpc":"2.0","method":"event","params":{"type":"shutting_down","time_ns":7}})";

std::string telemetry(int time_ns) {
  return R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":)" + std::to_string(time_ns) +
         "}}";
}

Connection connect(const FakeDaemon& daemon) {
  return Connection::open({daemon.address()}, kLongTimeout).value();
}

std::int64_t time_of(const Notification& notification) {
  if (const auto* event = std::get_if<protocol::EventMessage>(&notification))
    return event->event.time_ns;
  return std::get<protocol::TelemetryMessage>(notification).telemetry.status.time_ns;
}

TEST(Open, NamesTheAddressesTried) {
  const SilentPort silent;
  const auto none = Connection::open({{.path = "/nowhere.sock"}, silent.address()}, kLongTimeout);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().failure, Failure::kNoDaemon);
  EXPECT_EQ(none.error().message,
            "no daemon answers at /nowhere.sock or " + to_string(silent.address()));
}

TEST(Open, NamesOtherErrors) {
  const auto none = Connection::open({{.path = std::string(200, 'x')}}, 200ms);
  EXPECT_THAT(none.error().message, HasSubstr("x (file name too long)"));
}

TEST(Open, UsesTheFirstAddressThatAccepts) {
  FakeDaemon daemon([](FakePeer& peer) { peer.read(); });
  auto ball = Connection::open({SilentPort().address(), daemon.address()}, kLongTimeout);
  ASSERT_TRUE(ball.has_value());
  EXPECT_EQ(ball->address(), daemon.address());
}

TEST(Open, WorksOverAUnixSocketToo) {
  const TemporaryFolder folder;
  const std::string path = folder.path("hedgehogd.sock");
  FakeDaemon daemon(path, [](FakePeer& peer) {
    peer.read();
    peer.send_line(kPong);
  });
  auto ball = Connection::open({{.path = path}}, kLongTimeout);
  ASSERT_TRUE(ball.has_value());
  EXPECT_EQ(ball->call(protocol::Ping{}, kLongTimeout).value().time_ns, 42);
}

TEST(Call, SendsOneLineAndReturnsTheTypedResult) {
  std::string line;
  FakeDaemon daemon([&](FakePeer& peer) {
    line = peer.read();
    peer.send_line(
        R"({"jsonrpc":"2.0","id":1,"result":{"effect":41,"accepted":true,"limited_by":null,"current_a":9.3,"force_n":0.115,"pin":34,"headroom_s":21.4,"seq":9120,"new_field":1}})");
  });
  auto ball = connect(daemon);
  const protocol::EffectParams push{
      .direction = protocol::Word::kLeft, .level = 0.62, .duration_ms = 180};
  const auto felt =
      ball.call(protocol::EffectStart{model::EffectMethod::kPulse, push}, kLongTimeout).value();
  EXPECT_EQ(felt.effect, 41U);
  EXPECT_EQ(felt.current_a, 9.3);
  EXPECT_EQ(felt.headroom_s, 21.4);
  EXPECT_EQ(line, R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse","params":)"
                  R"({"direction":"left","level":0.62,"duration_ms":180}})");
}

TEST(Call, ReadsResponsesInAnyPieces) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    for (const char byte : std::string(kPong) + "\r\n") peer.send({&byte, 1});
    peer.read();
    peer.send(telemetry(1) + "\n" + telemetry(2) + "\n" +
              R"({"jsonrpc":"2.0","id":2,"result":{"time_ns":43}})" + "\n" + telemetry(3) + "\n");
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).value().time_ns, 42);
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).value().time_ns, 43);
  for (const int expected : {1, 2, 3})
    EXPECT_EQ(time_of(ball.next(kLongTimeout).value().value()), expected);
}

TEST(Call, ReturnsTheDaemonsError) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(
        R"({"jsonrpc":"2.0","id":1,"error":{"code":-32602,"message":"gain: 1.4 is above 1","data":{"name":"invalid_params","field":"gain","limit":1,"value":1.4}}})");
  });
  auto ball = connect(daemon);
  const auto refused = ball.call(protocol::OutputSetGain{1.4}, kLongTimeout);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().failure, Failure::kRefused);
  EXPECT_EQ(refused.error().message, "gain: 1.4 is above 1");
  ASSERT_TRUE(refused.error().refusal.has_value());
  EXPECT_EQ(refused.error().refusal->code, protocol::ErrorCode::kInvalidParams);
  EXPECT_EQ(refused.error().refusal->field, "gain");
}

TEST(Call, TreatsAnErrorWithoutIdAsItsOwn) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(
        R"({"jsonrpc":"2.0","id":null,"error":{"code":-32001,"message":"busy: too many connections","data":{"name":"busy"}}})");
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).error().message,
            "busy: too many connections");
}

TEST(Call, ForwardsRawParameters) {
  std::string line;
  FakeDaemon daemon([&](FakePeer& peer) {
    line = peer.read();
    peer.send_line(R"({"jsonrpc":"2.0","id":1,"result":{"b":1,"a":[2]}})");
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.call_raw("future.method", R"({"x":1})", kLongTimeout).value(),
            R"({"b":1,"a":[2]})");
  daemon.finish();
  EXPECT_EQ(line, R"({"jsonrpc":"2.0","id":1,"method":"future.method","params":{"x":1}})");
}

TEST(Call, ThatTimesOutLeavesTheConnectionUsable) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.read();
    peer.send_line(kPong);
    peer.send_line(R"({"jsonrpc":"2.0","id":2,"result":{"time_ns":43}})");
  });
  auto ball = connect(daemon);
  const auto late = ball.call(protocol::Ping{}, 20ms);
  ASSERT_FALSE(late.has_value());
  EXPECT_EQ(late.error().failure, Failure::kTimeout);
  EXPECT_EQ(late.error().message, "the daemon has not answered within 20 ms");
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).value().time_ns, 43);
}

TEST(Call, ReportsAClosedConnectionAndKeepsItsLastMessages) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kShutdown);
  });
  auto ball = connect(daemon);
  for (int i = 0; i < 2; ++i) {
    const auto closed = ball.call(protocol::Ping{}, kLongTimeout);
    ASSERT_FALSE(closed.has_value());
    EXPECT_EQ(closed.error().failure, Failure::kClosed);
  }
  const auto last_event = ball.next(kLongTimeout).value().value();
  EXPECT_EQ(std::get<protocol::EventMessage>(last_event).event.type, "shutting_down");
  EXPECT_EQ(ball.next(kLongTimeout).error().failure, Failure::kClosed);
}

TEST(Call, RejectsInvalidResponses) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line("HTTP/1.1 400 Bad Request");
    peer.read();
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).error().failure, Failure::kProtocol);
}

TEST(Call, RejectsALineWithoutAnEnd) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send(std::string(LineSocket::kMaxIncomingLine + 65'536, 'x'));
    peer.read();
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).error().failure, Failure::kProtocol);
}

TEST(Call, NeverSendsALineThatIsTooLong) {
  std::string line;
  FakeDaemon daemon([&](FakePeer& peer) { line = peer.read(); });
  auto ball = connect(daemon);
  const auto failed =
      ball.call_raw("x", "{\"y\":\"" + std::string(70'000, 'y') + "\"}", kLongTimeout);
  EXPECT_EQ(failed.error().failure, Failure::kProtocol);
  EXPECT_TRUE(ball.notify(protocol::DeviceEmergencyStop{}, kLongTimeout).has_value());
  daemon.finish();
  EXPECT_THAT(line, HasSubstr("device.emergency_stop"));
}

TEST(Notify, SendsNoId) {
  std::string line;
  FakeDaemon daemon([&](FakePeer& peer) { line = peer.read(); });
  EXPECT_TRUE(connect(daemon).notify(protocol::EffectStop{.effect = 41}, kLongTimeout).has_value());
  daemon.finish();
  EXPECT_EQ(line, R"({"jsonrpc":"2.0","method":"effect.stop","params":{"effect":41}})");
}

TEST(Request, DoesNotWaitAndItsResponsesAreReadLater) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.read();
    peer.send_line(R"({"jsonrpc":"2.0","id":1,"result":{"stopped":0,"seq":3}})");
    peer.send_line(
        R"({"jsonrpc":"2.0","id":2,"error":{"code":-32009,"message":"claimed: by another","data":{"name":"claimed"}}})");
    peer.send_line(telemetry(5));
    peer.read();
    peer.send_line(R"({"jsonrpc":"2.0","id":3,"result":{"time_ns":43}})");
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.request(protocol::EffectStopAll{}, kLongTimeout).value(), protocol::Id::number(1));
  EXPECT_EQ(ball.request(protocol::EffectStopAll{}, kLongTimeout).value(), protocol::Id::number(2));
  EXPECT_EQ(time_of(ball.next(kLongTimeout).value().value()), 5);
  EXPECT_TRUE(ball.response().value().result.has_value());
  const auto refused = ball.response().value();
  EXPECT_EQ(refused.id, protocol::Id::number(2));
  EXPECT_EQ(refused.result.error().code, protocol::ErrorCode::kClaimed);
  EXPECT_FALSE(ball.response().has_value());
  EXPECT_EQ(ball.call(protocol::Ping{}, kLongTimeout).value().time_ns, 43);
}

TEST(Next, WithTimeoutZeroReturnsOnlyBufferedMessages) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send(telemetry(1) + "\n" + telemetry(2) + "\n" + kPong + "\n" + R"({"jsonrpc":)");
    peer.read();
  });
  auto ball = connect(daemon);
  EXPECT_EQ(ball.next(0ms).value(), std::nullopt);
  ASSERT_TRUE(ball.call(protocol::Ping{}, kLongTimeout).has_value());
  EXPECT_EQ(time_of(ball.next(0ms).value().value()), 1);
  EXPECT_EQ(time_of(ball.next(0ms).value().value()), 2);
  EXPECT_EQ(ball.next(10ms).value(), std::nullopt) << "half a line is no line";
}

TEST(Next, DropsOldTelemetryButNoEvent) {
  FakeDaemon daemon([](FakePeer& peer) {
    peer.read();
    peer.send_line(kShutdown);
    for (int i = 1; i <= 300; ++i) peer.send_line(telemetry(1000 + i));
    peer.send_line(kPong);
    peer.read();
  });
  auto ball = connect(daemon);
  ASSERT_TRUE(ball.call(protocol::Ping{}, kLongTimeout).has_value());
  EXPECT_EQ(time_of(ball.next(0ms).value().value()), 7);
  for (int i = 45; i <= 300; ++i) EXPECT_EQ(time_of(ball.next(0ms).value().value()), 1000 + i);
  EXPECT_EQ(ball.next(0ms).value(), std::nullopt);
}

}  // namespace
}  // namespace hedgehog::client
