// SPDX-License-Identifier: MIT
// When the io thread looks at the ball: signalled by control's events, and in time for telemetry.
#include "daemon/server/device/event_wait.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <chrono>

#include "tests/server/server_rig.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using std::chrono::steady_clock;

bool raised(const control::EventSignal& signal) {
  pollfd poll{signal.descriptor(), POLLIN, 0};
  return ::poll(&poll, 1, 0) == 1;
}

/// Median duration of 51 waits, each with or without an event.
steady_clock::duration median_wait(model::Tick ticks, bool events, const control::Pace& pace = {}) {
  asio::io_context io{1};
  control::EventSignal signal;
  EventWait wait(io, signal, pace);
  std::array<steady_clock::duration, 51> waits;
  asio::co_spawn(
      io,
      [&]() -> asio::awaitable<void> {
        for (steady_clock::duration& one : waits) {
          if (events) signal.raise();
          const auto begun = steady_clock::now();
          co_await wait.wait(ticks);
          one = steady_clock::now() - begun;
        }
        io.stop();
      },
      asio::detached);
  io.run();
  std::nth_element(waits.begin(), waits.begin() + waits.size() / 2, waits.end());
  return waits[waits.size() / 2];
}

TEST(EventWait, AnEventEndsTheWait) {
  const auto without = median_wait(TelemetryPublisher::kNever, false);
  EXPECT_GE(without, EventWait::kLongest);
  EXPECT_LT(median_wait(TelemetryPublisher::kNever, true), without / 2);
}

TEST(EventWait, EndsWithTheTickThatIsDue) {
  const auto longest = median_wait(TelemetryPublisher::kNever, false);
  const auto four_ms = median_wait(20, false, {.speed = 5});
  EXPECT_GE(four_ms, std::chrono::milliseconds(4));
  EXPECT_LT(four_ms, longest);
  // The snapshot may be nearly a step old.
  EXPECT_LT(median_wait(20, false, {.speed = 1, .step_ms = 18}), longest);
}

TEST(EventWait, ControlRaisesTheSignalForEveryEvent) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.call(client, "device.arm");
  rig.run(20);
  const auto& signal = rig.mailbox->wake_io;
  rig.mailbox->wake_io.take();
  rig.run(50);
  EXPECT_FALSE(raised(signal)) << "there was no event";
  rig.call(client, "effect.pulse", {{"direction", "left"}, {"duration_ms", 30}});
  rig.run(5);
  EXPECT_TRUE(raised(signal)) << "it has started";
  rig.mailbox->wake_io.take();
  rig.run(100);
  EXPECT_TRUE(raised(signal)) << "it has ended";
}

TEST(EventWait, PumpsAreDueForTelemetryAndForClientsThatWaitForATick) {
  ServerRig rig;
  FakeClient& client = rig.connect();
  rig.call(client, "events.subscribe");
  rig.run(1);
  EXPECT_EQ(rig.server->pump_due_in(), TelemetryPublisher::kNever);
  rig.run_without_pump(6);
  rig.mailbox->wake_io.take();
  rig.call(client, "telemetry.subscribe", {{"rate_hz", 20}});
  EXPECT_TRUE(raised(rig.mailbox->wake_io)) << "the first telemetry is that of the next tick";
  FakeClient& faster = rig.connect();
  rig.call(faster, "telemetry.subscribe", {{"rate_hz", 100}});
  rig.run(1);
  for (int i = 0; i < 200; ++i) {
    const model::Tick due_in = rig.server->pump_due_in();
    ASSERT_GE(due_in, 1);
    ASSERT_LE(due_in, 10);
    client.lines.clear();
    faster.lines.clear();
    rig.run(due_in - 1);
    ASSERT_TRUE(client.lines.empty() && faster.lines.empty()) << "before it was due";
    rig.run(1);
    ASSERT_FALSE(client.lines.empty() && faster.lines.empty()) << "not when it was due";
  }
  rig.call(client, "telemetry.unsubscribe");
  rig.call(faster, "telemetry.unsubscribe");
  rig.run(50);
  EXPECT_EQ(rig.server->pump_due_in(), TelemetryPublisher::kNever);
  rig.mailbox->wake_io.take();
  rig.server->line(client.session,
                   R"({"jsonrpc": "2.0", "id": 1, "method": "device.emergency_stop"})");
  EXPECT_EQ(rig.server->pump_due_in(), 1);
  EXPECT_TRUE(raised(rig.mailbox->wake_io)) << "it does not wait for the end of a pause";
}

}  // namespace
}  // namespace hedgehog::server
