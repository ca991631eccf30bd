// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "daemon/device/tick_clock.h"
#include "tests/bench/load/client.h"
#include "tests/bench/load/concurrently.h"
#include "tests/bench/load/crowd.h"
#include "tests/bench/load/daemon.h"
#include "tests/bench/load/scenarios.h"

namespace hedgehog::bench {
namespace {

constexpr double kTickUs = 1000.0;
constexpr int kMaxFurtherPulses = 200;

/// Sends a pulse, reads its response, and returns the device time at which it began, ns.
std::int64_t play_pulse(Client& client) {
  client.send(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse",)"
              R"("params":{"direction":"left","duration_ms":5,"current_a":5}})"
              "\n");
  bool answered = false;
  for (std::optional<std::int64_t> begun_ns;;) {
    const auto message = nlohmann::json::parse(client.line());
    if (message.contains("error"))
      throw std::runtime_error("a pulse was refused: " + message.dump());
    if (message.contains("method"))
      begun_ns = message["params"]["time_ns"].get<std::int64_t>();
    else
      answered = true;
    if (answered && begun_ns) return *begun_ns;
  }
}

/// Device time, in ms (ticks), from sending a pulse to the tick that begins it.
std::vector<double> pulse_delays(int port, double seconds) {
  Client client(port);
  client.call(R"({"jsonrpc":"2.0","id":1,"method":"events.subscribe",)"
              R"("params":{"types":["effect_started"]}})"
              "\n");
  std::minstd_rand random(7);
  std::uniform_int_distribution<int> pause_us(2000, 6000);
  std::vector<double> delays;
  const std::int64_t until = device::monotonic_ns() + std::llround(seconds * 1e9);
  while (device::monotonic_ns() < until || delays.empty()) {
    // Sends at a random phase of the tick.
    std::this_thread::sleep_for(std::chrono::microseconds(pause_us(random)));
    const std::int64_t sent_ns = device::monotonic_ns();
    delays.push_back(1e-6 * static_cast<double>(play_pulse(client) - sent_ns));
  }
  return delays;
}

void add_pulses(const Daemon& daemon, const std::string& scenario, double seconds,
                Figures& figures) {
  std::vector<double> delays = pulse_delays(daemon.port(), seconds);
  std::optional<Daemon::Quantiles> own = daemon.request_to_board();
  // On a busy machine a pulse can end before one of its set-points is written.
  for (int further = 0; !own; ++further, own = daemon.request_to_board()) {
    if (further == kMaxFurtherPulses) throw std::runtime_error("no pulse has reached the board");
    for (const double delay : pulse_delays(daemon.port(), 0.0)) delays.push_back(delay);
  }
  figures[scenario + " p50_ticks"] = quantile(delays, 0.5);
  figures[scenario + " p99_ticks"] = quantile(delays, 0.99);
  figures[scenario + " own p50_ticks"] = own->p50_us / kTickUs;
  figures[scenario + " own p99_ticks"] = (own->p99_us - daemon.lateness().p99_us) / kTickUs;
}

}  // namespace

void measure_pulse(const Setup& setup, Figures& figures) {
  add_pulses(Daemon(setup.daemon()), "pulse", setup.seconds, figures);
  const Daemon daemon(setup.daemon());
  Crowd crowd(daemon.port(), kCrowd, 1);
  concurrently([&] { crowd.run(1.2 * setup.seconds); },
               [&] { add_pulses(daemon, "busy pulse", setup.seconds, figures); });
}

}  // namespace hedgehog::bench
