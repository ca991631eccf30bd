// SPDX-License-Identifier: MIT
// The threads that run the controller, through the mailbox as the io thread uses it. Waits for
// required events, never for fixed durations.
#include "daemon/control/loop/loop.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <numeric>
#include <thread>

#include "daemon/control/loop/control_loop.h"
#include "daemon/control/loop/lockstep_loop.h"
#include "daemon/device/tick_clock.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

/// Device time runs up to a hundred times as fast here; no effect may end by its lease: this is
/// eleven hours at that pace.
constexpr std::uint32_t kUnlimited = 4'000'000'000;

/// The io side: a mailbox, and a wait with a timeout.
class Io {
 public:
  bool wait(const std::function<bool()>& done) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < until) {
      status = mailbox->status.read();
      mailbox->events.consume_all([&](const Event& event) { events.push_back(event); });
      if (done()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  bool armed() {
    return wait([&] { return status.state == State::kArmed; });
  }
  void start(std::uint8_t place, const model::EffectSpec& spec) {
    StartEffect start;
    start.effect = place + 1000u;
    start.place = place;
    start.spec = spec;
    ASSERT_TRUE(mailbox->commands.push({++seq, start}));
  }

  std::unique_ptr<Mailbox> mailbox = std::make_unique<Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
  FlightRecorder recorder{std::size_t{1} << 20};
  StatusSnapshot status;
  std::vector<Event> events;
  std::uint64_t seq = 0;
};

TEST(LockstepLoop, PlaysEffectsAndStopsSafely) {
  Io io;
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, &io.recorder, {},
                    {.speed = 20});
  loop.start();
  ASSERT_TRUE(io.armed());
  io.start(3, rig::hold({1, 0, 0}, 5.0, kUnlimited));
  ASSERT_TRUE(
      io.wait([&] { return io.status.applied_seq == 1 && io.status.board.current_a.x > 4.9; }));
  EXPECT_EQ(io.status.effects[3].effect, 1003u);
  // It counts completed wake-ups; the effect may have begun within the first.
  EXPECT_TRUE(io.wait([&] { return loop.heartbeat() > 0; }));
  EXPECT_GE(loop.now(), io.status.tick - 100);
  EXPECT_TRUE(loop.stop()) << "the board has confirmed that its bridges sleep";
  EXPECT_TRUE(loop.stop());
  ASSERT_TRUE(io.wait(
      [&] { return !io.events.empty() && io.events.back().type == EventType::kEffectEnded; }));
  EXPECT_EQ(io.events.back().end_reason, EndReason::kStopped);
  EXPECT_FALSE(io.port->reports.read().telemetry.bridges_awake);
}

TEST(LockstepLoop, RunsMinutesOfHeatInSeconds) {
  Io io;
  device::SimulatedBoardOptions board;
  board.start_c = 58.0;
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, nullptr, board,
                    {.speed = 100});
  loop.start();
  ASSERT_TRUE(io.armed());
  io.start(0, rig::hold({1, 0, 0}, 15.0, kUnlimited));
  ASSERT_TRUE(io.wait([&] { return io.status.derating; }));
  EXPECT_GT(io.status.thermal.hottest_c, 59.0);
}

/// The wake-ups of a loop up to its last tick.
std::uint64_t wake_ups(const LoopStatistics& loop) {
  const auto& counts = loop.lateness.counts;
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

TEST(LockstepLoop, ALongerStepHasFewerWakeUpsAndTheSamePace) {
  constexpr Pace kPace{.speed = 5, .step_ms = 10};
  constexpr std::uint64_t kTicks = 50;
  Io io;
  const std::int64_t begun_ns = device::monotonic_ns();
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, nullptr, {}, kPace);
  loop.start();
  ASSERT_TRUE(io.wait([&] { return io.status.loop.ticks > 10 * kTicks; }));
  const std::int64_t run_ns = device::monotonic_ns() - begun_ns;
  EXPECT_LE(io.status.tick, kPace.speed * run_ns / model::kNanosecondsPerTick);
  EXPECT_EQ(wake_ups(io.status.loop), (io.status.loop.ticks + kTicks - 1) / kTicks);
}

TEST(LockstepLoop, AStepHasAHundredTicksAtMost) {
  Io io;
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, nullptr, {},
                    {.speed = 40, .step_ms = 1000});
  loop.start();
  ASSERT_TRUE(io.wait([&] { return io.status.loop.ticks > 400; }));
  // 40 times real time fit twice.
  EXPECT_EQ(wake_ups(io.status.loop), (io.status.loop.ticks + 79) / 80);
}

TEST(LockstepLoop, AnEmergencyStopWorksWithAFullQueue) {
  Io io;
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, nullptr, {},
                    {.speed = 10});
  loop.start();
  ASSERT_TRUE(io.armed());
  io.start(0, rig::hold({1, 0, 0}, 5.0, kUnlimited));
  ASSERT_TRUE(io.wait([&] { return io.status.limited_a.x > 4.9; }));
  while (io.mailbox->commands.push({++io.seq, SetGain{1.0}})) {
  }
  io.mailbox->emergency_generation.fetch_add(1);
  ASSERT_TRUE(io.wait([&] { return io.status.state == State::kDisarmed; }));
  EXPECT_EQ(io.status.latch, Reason::kEmergencyStop);
}

TEST(LockstepLoop, NoEndedEventIsLostWhileTheyAreUnread) {
  Io io;
  LockstepLoop loop(rig::RigOptions::armed_at_start(), *io.mailbox, *io.port, nullptr, {},
                    {.speed = 50});
  // The queue is full before the loop starts.
  while (io.mailbox->events.push(Event{})) {
  }
  loop.start();
  // Effects in all places are started and end; io reads no events.
  const auto run_until = [&](const std::function<bool(const StatusSnapshot&)>& there) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!there(io.mailbox->status.read()) && std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  run_until([](const StatusSnapshot& s) { return s.state == State::kArmed; });
  for (std::uint8_t place = 0; place < kMaxEffects; ++place)
    io.start(place, rig::pulse({1, 0, 0}, 1.0, 5));
  run_until([](const StatusSnapshot& s) { return s.applied_seq >= kMaxEffects; });
  int ended = 0;
  ASSERT_TRUE(io.wait([&] {
    ended = 0;
    for (const Event& event : io.events) ended += event.type == EventType::kEffectEnded ? 1 : 0;
    return ended == kMaxEffects;
  }));
}

TEST(ControlLoop, ReportsAnAbsentBoardAndKeepsTicking) {
  Io io;
  ControlLoop loop(ControlSettings{}, *io.mailbox, *io.port, nullptr);
  loop.start();
  ASSERT_TRUE(io.wait([&] { return io.status.tick > 20 && loop.heartbeat() > 0; }));
  EXPECT_EQ(io.status.state, State::kAbsent);
  EXPECT_GT(io.port->commands.read().count, 0u);
  EXPECT_FALSE(io.port->commands.read().board.enable());
  EXPECT_FALSE(loop.stop()) << "nobody has confirmed anything";
}

TEST(ControlLoop, CountsEveryTickOfTheGridOnce) {
  Io io;
  ControlLoop loop(ControlSettings{}, *io.mailbox, *io.port, nullptr);
  // Ticks of the grid that were not counted: those before the thread began, and no others.
  const auto uncounted = [&] {
    return static_cast<std::uint64_t>(io.status.tick) - io.status.loop.ticks -
           io.status.loop.skipped;
  };
  loop.start();
  ASSERT_TRUE(io.wait([&] { return io.status.loop.ticks > 0; }));
  const std::uint64_t before = uncounted();
  ASSERT_TRUE(io.wait([&] { return io.status.loop.ticks > 100; }));
  EXPECT_EQ(uncounted(), before);
  loop.stop();
  io.status = io.mailbox->status.read();
  EXPECT_EQ(uncounted(), before);
}

}  // namespace
}  // namespace hedgehog::control
