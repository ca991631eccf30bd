// SPDX-License-Identifier: MIT
// A run is pinned to one start of its daemon: after a restart nothing is played unless the
// experimenter confirms it.
#include "clients/study/session/runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>

#include "tests/clients/fake_daemon.h"
#include "tests/study/fake_responses.h"
#include "tests/study/preset.h"
#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

using namespace std::chrono_literals;
using client::FakeDaemon;
using client::FakePeer;
using nlohmann::json;

/// Answers until the client requests `last` or disconnects; counts the requested circles. Each
/// status is a minute of the ball's time after the one before.
FakeDaemon::Script daemon_of(json responses, std::string last, std::atomic<int>& circles) {
  return [=, &circles](FakePeer& peer) {
    std::chrono::nanoseconds now{};
    for (std::string line = peer.read(); !line.empty(); line = peer.read()) {
      const json request = json::parse(line);
      const std::string method = request["method"];
      circles += method == "effect.circle" ? 1 : 0;
      if (method == last) return;
      if (!request.contains("id")) continue;
      json result = method == "ping" ? json{{"time_ns", 1'000'000'000}} : responses.at(method);
      if (method == "device.status") result["time_ns"] = (now += 1min).count();
      peer.send_line(json{{"jsonrpc", "2.0"}, {"id", request["id"]}, {"result", result}}.dump());
    }
  };
}

/// Enters "continue" until the shown message contains `message`, then `word` at the `calls`-th call
/// of wait().
class ScriptedDesk : public Desk {
 public:
  explicit ScriptedDesk(Input::Kind word, std::string message = "was restarted", int calls = 20)
      : word_(word), awaited_(std::move(message)), calls_(calls) {}
  void show(const View& view) override { message_ = view.message; }
  Input wait(std::chrono::milliseconds) override {
    Input input;
    if (message_.find(awaited_) == std::string::npos)
      input.kind = waits_ == 0 ? Input::Kind::kContinue : Input::Kind::kNone;
    else if (++waits_ == calls_)
      input.kind = word_;
    return input;
  }
  bool unattended() const override { return false; }
  int waits() const { return waits_; }

 private:
  Input::Kind word_;
  std::string awaited_;
  int calls_;
  std::string message_{};
  int waits_ = 0;
};

class Pinned : public testing::Test {
 protected:
  std::string socket() const { return folder_.path("ball.sock"); }

  Journal start_journal(const Player& player) const {
    RunStarted header;
    header.participant = "P01";
    header.experiment = preset("force-threshold");
    header.ball = player.ball();
    header.daemon = player.pin().daemon;
    return Journal::create(folder_.path("run.jsonl"), header).value();
  }
  /// A run whose daemon ends at the first circle; the next daemon at its address answers with
  /// `next`,
  /// until `last` is requested.
  RunEnd run(const json& next, const std::string& last, Input::Kind word) {
    client::Address address;
    address.path = socket();
    FakeDaemon first(socket(),
                     daemon_of(fake_responses("0000000000000001"), "effect.circle", before_));
    auto player = Player::open({address}, 5s, 20s);
    EXPECT_TRUE(player) << player.error().message;
    Journal journal = start_journal(*player);
    ScriptedDesk desk(word);
    std::filesystem::remove(socket());
    FakeDaemon second(socket(), daemon_of(next, last, after_));
    Runner runner(journal, *std::move(player), desk, [&] { return after_ > 0; });
    const auto end = runner.run();
    waits_ = desk.waits();
    journal_ = read_journal(folder_.path("run.jsonl")).value();
    return end.value();
  }
  int count_changes() const {
    int changes = 0;
    for (const Line& line : journal_)
      changes += std::holds_alternative<DaemonChanged>(line.event) ? 1 : 0;
    return changes;
  }

  TemporaryFolder folder_;
  std::atomic<int> before_ = 0;
  std::atomic<int> after_ = 0;
  int waits_ = 0;
  std::vector<Line> journal_{};
};

TEST_F(Pinned, ARunPlaysNothingOnAnotherStartWithoutConfirmation) {
  EXPECT_EQ(run(fake_responses("0000000000000002"), "never", Input::Kind::kStop), RunEnd::kStopped);
  EXPECT_EQ(before_, 1);
  EXPECT_EQ(after_, 0);
  EXPECT_GE(waits_, 20);
  EXPECT_EQ(count_changes(), 0);
}

TEST_F(Pinned, ARunContinuesWhenTheExperimenterConfirms) {
  EXPECT_EQ(run(fake_responses("0000000000000002"), "effect.circle", Input::Kind::kContinue),
            RunEnd::kStopped);
  EXPECT_EQ(after_, 1);
  EXPECT_EQ(count_changes(), 1);
  EXPECT_EQ(RecordedRun::replay(journal_).value().pin().daemon.start_id, "0000000000000002");
}

TEST_F(Pinned, ADaemonThatReportsNoStartIsNotTheSameSimulator) {
  EXPECT_EQ(run(fake_responses(), "never", Input::Kind::kStop), RunEnd::kStopped);
  EXPECT_EQ(after_, 0);
  EXPECT_GE(waits_, 20);
}

// Only the first connection tries all addresses; later ones use the address of the run's daemon.
TEST_F(Pinned, ARunConnectsToNoOtherAddressWhenItsDaemonEnds) {
  client::Address address;
  address.path = socket();
  client::Address elsewhere;
  elsewhere.path = folder_.path("other.sock");
  std::atomic<bool> over = false;
  std::atomic<bool> visited = false;
  FakeDaemon other(elsewhere.path, [&](FakePeer&) { visited = !over; });
  FakeDaemon first(socket(),
                   daemon_of(fake_responses("0000000000000001"), "effect.circle", before_));
  auto player = Player::open({address, elsewhere}, 5s, 20s);
  ASSERT_TRUE(player) << player.error().message;
  Journal journal = start_journal(*player);
  std::filesystem::remove(socket());
  ScriptedDesk desk(Input::Kind::kStop, "waiting for the ball", 1);
  Runner runner(journal, *std::move(player), desk, [] { return false; });
  EXPECT_EQ(runner.run().value(), RunEnd::kStopped);
  EXPECT_EQ(before_, 1);
  over = true;
  // Ends the other daemon's conversation, which waits for a client.
  (void)client::Connection::open({elsewhere});
  other.finish();
  EXPECT_FALSE(visited);
}

TEST_F(Pinned, ALostConnectionIsReestablished) {
  EXPECT_EQ(run(fake_responses("0000000000000001"), "effect.circle", Input::Kind::kStop),
            RunEnd::kStopped);
  EXPECT_EQ(after_, 1);
  EXPECT_EQ(waits_, 0);
  EXPECT_EQ(count_changes(), 0);
}

/// No experimenter, who could end the wait for the ball; counts the views of a paused run.
class EmptyDesk : public Desk {
 public:
  void show(const View& view) override { pauses_ += view.phase == Phase::kPaused ? 1 : 0; }
  Input wait(std::chrono::milliseconds) override { return {}; }
  bool unattended() const override { return true; }
  int pauses() const { return pauses_; }

 private:
  int pauses_ = 0;
};

TEST_F(Pinned, AnUnattendedRunWaitsForHalfAnHourOfTheBallsTimeForItToCool) {
  json responses = fake_responses("0000000000000001");
  responses["thermal.forecast"]["seconds_to_derating"] = 0.1;
  FakeDaemon daemon(socket(), daemon_of(responses, "effect.circle", before_));
  client::Address address;
  address.path = socket();
  auto player = Player::open({address}, 5s, 20s);
  ASSERT_TRUE(player) << player.error().message;
  Journal journal = start_journal(*player);
  EmptyDesk desk;
  Runner runner(journal, *std::move(player), desk, [] { return false; });
  EXPECT_EQ(runner.run().value(), RunEnd::kStuck);
  EXPECT_EQ(desk.pauses(), 32) << "the first minute, thirty more, and one too late";
  EXPECT_THAT(runner.stuck_reason(), testing::HasSubstr("cooling down"));
}

}  // namespace
}  // namespace hedgehog::study
