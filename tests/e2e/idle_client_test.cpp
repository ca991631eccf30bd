// SPDX-License-Identifier: MIT
// What a client that only watches costs the daemon.
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {
namespace {

/// How often the io thread, the first one, has gone to sleep.
long sleeps(const DaemonProcess& daemon) {
  std::ifstream status("/proc/" + std::to_string(daemon.pid()) + "/status");
  for (std::string word; status >> word;) {
    long count = 0;
    if (word == "voluntary_ctxt_switches:" && status >> count) return count;
  }
  ADD_FAILURE() << "no count";
  return 0;
}

TEST(IdleClient, TelemetryAtOneHertzAndEventsDoNotWakeTheDaemonEachMillisecond) {
  const Home home;
  DaemonProcess daemon(home);
  RawClient watcher(daemon.port());
  watcher.call("events.subscribe", {{"scope", "all"}});
  watcher.call("telemetry.subscribe", {{"rate_hz", 1}});
  watcher.notification("telemetry");
  const auto begun = std::chrono::steady_clock::now();
  const long before = sleeps(daemon);
  for (int i = 0; i < 3; ++i) watcher.notification("telemetry");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  // 100 a second; each millisecond they would be nearly 1000, and fewer on a busy machine.
  EXPECT_LT(static_cast<double>(sleeps(daemon) - before) / took.count(), 400);
}

}  // namespace
}  // namespace hedgehog::e2e
