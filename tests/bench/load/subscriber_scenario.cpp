// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/load/client.h"
#include "tests/bench/load/concurrently.h"
#include "tests/bench/load/daemon.h"
#include "tests/bench/load/scenarios.h"
#include "tests/bench/load/server.h"
#include "tests/bench/load/subscribers.h"

namespace hedgehog::bench {
namespace {

using Clock = std::chrono::steady_clock;

void add_subscribers(const std::string& name, const Child& server, Subscribers& subscribers,
                     const Setup& setup, Figures& figures) {
  const double before_s = server.cpu_s();
  const Received received = subscribers.run(2.0 * setup.seconds);
  const double spent_s = server.cpu_s() - before_s;
  const auto notifications = static_cast<double>(std::max<std::size_t>(1, received.notifications));
  const auto missing = static_cast<double>(received.missing);
  figures["subscribers " + name + " hz"] =
      notifications / received.seconds / static_cast<double>(setup.subscribers);
  figures["subscribers " + name + " missing_percent"] = 100.0 * missing / (notifications + missing);
  figures["subscribers " + name + " cpu_percent"] = 100.0 * spent_s / received.seconds;
  figures["subscribers " + name + " cpu_us"] = 1e6 * spent_s / notifications;
}

/// Pings at long intervals, so that they add no load: duration of each, s.
std::vector<double> rare_pings(Client& client, double seconds) {
  std::vector<double> took_s;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < until || took_s.empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto sent = Clock::now();
    client.call(kPing);
    took_s.push_back(std::chrono::duration<double>(Clock::now() - sent).count());
  }
  return took_s;
}

void subscribe_to_daemon(const Setup& setup, Figures& figures) {
  const Daemon daemon(setup.daemon());
  Client client(daemon.port());
  Subscribers subscribers(daemon.port(), setup.subscribers);
  subscribers.run(setup.seconds);
  std::vector<double> took_s;
  concurrently([&] { took_s = rare_pings(client, 2.0 * setup.seconds); },
               [&] { add_subscribers("daemon", daemon.process(), subscribers, setup, figures); });
  figures["subscribers daemon ping_us"] = 1e6 * quantile(took_s, 0.5);
  figures["subscribers daemon lateness_p99_us"] = daemon.lateness().p99_us;
}

void subscribe_to_sender(const Setup& setup, Figures& figures) {
  const Server sender({setup.reference_program("telemetry_sender"), std::to_string(kSubscribedHz)});
  Subscribers subscribers(sender.port(), setup.subscribers);
  subscribers.run(setup.seconds);
  add_subscribers("sender", sender.process(), subscribers, setup, figures);
}

}  // namespace

void measure_subscribers(const Setup& setup, Figures& figures) {
  in_turn(setup.round, {[&] {
                          if (setup.with_references) subscribe_to_sender(setup, figures);
                        },
                        [&] { subscribe_to_daemon(setup, figures); }});
}

}  // namespace hedgehog::bench
