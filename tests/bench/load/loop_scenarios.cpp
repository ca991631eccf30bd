// SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "daemon/device/tick_clock.h"
#include "tests/bench/load/child.h"
#include "tests/bench/load/client.h"
#include "tests/bench/load/concurrently.h"
#include "tests/bench/load/crowd.h"
#include "tests/bench/load/daemon.h"
#include "tests/bench/load/scenarios.h"
#include "tests/temporary_folder.h"

namespace hedgehog::bench {
namespace {

/// Effects and clients of the busiest tick that clients can cause.
constexpr int kEffectsOfClient = 32;
constexpr int kPlayers = 2;

void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// Why cyclictest, which needs a real-time priority, cannot run here; empty if it can.
std::string cyclictest_blocker() {
  if (installed("cyclictest").empty()) return "cyclictest is not installed (rt-tests)";
  rlimit priority{};
  ::getrlimit(RLIMIT_RTPRIO, &priority);
  const bool allowed =
      ::geteuid() == 0 || priority.rlim_cur >= static_cast<rlim_t>(device::kControlPriority);
  return allowed ? "" : "cyclictest may not run here (ulimit -r)";
}

/// Command line of cyclictest with the control thread's priority.
std::vector<std::string> cyclictest(double seconds) {
  return {"cyclictest",
          "--quiet",
          "--mlockall",
          "--threads=1",
          "--interval=1000",
          "--histogram=20000",
          "--priority=" + std::to_string(device::kControlPriority),
          "--loops=" + std::to_string(std::lround(seconds * 1000.0))};
}

/// The status may omit the ticks of the last so many seconds.
constexpr double kSumS = 1.1;
/// Duration of the daemon's start under stress.
constexpr double kStartS = 0.5;

/// Adds the lateness of the daemon's loop since its start, and of cyclictest's in the same time.
void add_lateness(const std::string& scenario, const Daemon& daemon, const Setup& setup,
                  Figures& figures) {
  const std::string blocker = cyclictest_blocker();
  const bool beside_cyclictest = setup.with_references && blocker.empty();
  std::string counts;
  if (beside_cyclictest)
    counts = Child(cyclictest(setup.seconds + kSumS)).finish();
  else
    wait(setup.seconds + kSumS);
  const Daemon::Quantiles late = daemon.lateness();
  figures[scenario + " daemon p50_us"] = late.p50_us;
  figures[scenario + " daemon p99_us"] = late.p99_us;
  for (const auto& [name, q] : {std::pair{"p50_us", 0.5}, std::pair{"p99_us", 0.99}}) {
    const std::string figure = scenario + " cyclictest " + name;
    if (beside_cyclictest)
      figures[figure] = quantile_us(counts, q);
    else
      figures.left_out[figure] = blocker;
  }
}

void play_many_effects(Client& client) {
  for (int i = 0; i < kEffectsOfClient; ++i) {
    const std::string response =
        client.call(R"({"jsonrpc":"2.0","id":1,"method":"effect.vibrate","params":{"slot":"s)" +
                    std::to_string(i) +
                    R"(","waveform":"sine","frequency_hz":60,"current_a":0.1,"lease_ms":10000}})"
                    "\n");
    if (response.find(R"("accepted":true)") == response.npos)
      throw std::runtime_error("an effect was not accepted: " + response);
  }
}

double loop_tick_us(const Setup& setup) {
  Child loop({setup.reference_program("timer_loop")});
  loop.line_after("loops");
  const double before_s = loop.cpu_s();
  wait(setup.seconds);
  return 1e3 * (loop.cpu_s() - before_s) / setup.seconds;
}

void add_tick_work(const Setup& setup, Figures& figures) {
  const Daemon daemon(setup.daemon());
  std::vector<Client> players;
  for (int i = 0; i < kPlayers; ++i) play_many_effects(players.emplace_back(daemon.port()));
  Client watcher(daemon.port());
  watcher.send(R"({"jsonrpc":"2.0","id":1,"method":"telemetry.subscribe",)"
               R"("params":{"rate_hz":100,"fields":["pins"]}})"
               "\n");
  const DelayHistogram before = daemon.histogram("tick_work_seconds");
  const double before_s = daemon.process().cpu_s("control");
  const auto until =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(setup.seconds);
  while (std::chrono::steady_clock::now() < until) watcher.line();
  const double spent_s = daemon.process().cpu_s("control") - before_s;
  const DelayHistogram work = daemon.histogram("tick_work_seconds").since(before);
  figures["work daemon work_us"] = work.mean_us();
  figures["work daemon tick_us"] = 1e6 * spent_s / std::max(1.0, work.count());
}

double share_percent(const Child& process, double seconds) {
  const double before_s = process.cpu_s();
  const auto begun = std::chrono::steady_clock::now();
  wait(seconds);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  return 100.0 * (process.cpu_s() - before_s) / took.count();
}

}  // namespace

void measure_lateness(const Setup& setup, Figures& figures) {
  add_lateness("lateness", Daemon(setup.daemon()), setup, figures);
}

void measure_lateness_under_requests(const Setup& setup, Figures& figures) {
  const Daemon daemon(setup.daemon());
  Crowd crowd(daemon.port(), kCrowd, 1);
  concurrently([&] { crowd.run(setup.seconds + kSumS); },
               [&] { add_lateness("requests lateness", daemon, setup, figures); });
}

void measure_lateness_under_stress(const Setup& setup, Figures& figures) {
  if (installed("stress-ng").empty()) {
    for (const char* figure : {"daemon p50_us", "daemon p99_us"})
      figures.left_out[std::string("stress lateness ") + figure] = "stress-ng is not installed";
    return;
  }
  const long seconds = std::lround(std::ceil(setup.seconds + kSumS + kStartS));
  const TemporaryFolder folder;
  Child stress({"stress-ng", "--quiet", "--cpu", "4", "--io", "2", "--temp-path", folder.path(),
                "--timeout", std::to_string(seconds) + "s"});
  add_lateness("stress lateness", Daemon(setup.daemon()), setup, figures);
  stress.finish();
}

void measure_tick_work(const Setup& setup, Figures& figures) {
  in_turn(setup.round, {[&] {
                          if (setup.with_references)
                            figures["work loop tick_us"] = loop_tick_us(setup);
                        },
                        [&] { add_tick_work(setup, figures); }});
  if (setup.with_references)
    figures["work daemon own_us"] = figures["work daemon tick_us"] - figures["work loop tick_us"];
}

void measure_idle(const Setup& setup, Figures& figures) {
  const auto loop = [&] {
    if (!setup.with_references) return;
    Child process({setup.reference_program("timer_loop")});
    process.line_after("loops");
    figures["idle loop percent"] = share_percent(process, setup.seconds);
  };
  const auto daemon_alone = [&] {
    const Daemon daemon(setup.daemon());
    {
      Client client(daemon.port());
      client.call(R"({"jsonrpc":"2.0","id":1,"method":"device.emergency_stop"})"
                  "\n");
    }
    wait(kStartS);
    figures["idle daemon disarmed_percent"] = share_percent(daemon.process(), setup.seconds);
  };
  const auto daemon_with_client = [&] {
    const Daemon daemon(setup.daemon());
    Client client(daemon.port());
    client.call(kPing);
    wait(kStartS);
    figures["idle daemon percent"] = share_percent(daemon.process(), setup.seconds);
  };
  in_turn(setup.round, {loop, daemon_alone, daemon_with_client});
}

}  // namespace hedgehog::bench
