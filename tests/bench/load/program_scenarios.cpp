// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/load/child.h"
#include "tests/bench/load/client.h"
#include "tests/bench/load/daemon.h"
#include "tests/bench/load/scenarios.h"
#include "tests/bench/load/server.h"

namespace hedgehog::bench {
namespace {

/// Ticks of an hour of plant that a fast machine computes in a second.
constexpr double kPlantTicksS = 200'000.0;
/// Notifications per second to the C++ client.
constexpr const char* kNotificationsHz = "10000";

void add_memory(const std::string& name, const Child& server, int port, std::size_t connections,
                Figures& figures) {
  Client first(port);
  first.call(kPing);
  const double before_kb = server.resident_kb();
  std::vector<Client> clients;
  clients.reserve(connections);
  for (std::size_t i = 0; i < connections; ++i) clients.emplace_back(port).call(kPing);
  figures["memory " + name + " mb"] = before_kb / 1024.0;
  figures["memory " + name + " connection_kb"] =
      (server.resident_kb() - before_kb) / static_cast<double>(connections);
}

/// The numbers that a program prints, one per line.
std::vector<double> numbers_of(std::vector<std::string> words) {
  std::istringstream text(Child(std::move(words)).finish());
  std::vector<double> numbers;
  for (double number = 0.0; text >> number;) numbers.push_back(number);
  if (numbers.size() != 2) throw std::runtime_error("a program printed no two numbers");
  return numbers;
}

/// False if an older revision has no program that measures this.
bool has(const std::string& program, const std::string& figure, Figures& figures) {
  const bool found = ::access(program.c_str(), X_OK) == 0;
  if (!found) figures.left_out[figure] = "the revision has no such program";
  return found;
}

}  // namespace

void measure_memory(const Setup& setup, Figures& figures) {
  in_turn(setup.round,
          {[&] {
             if (!setup.with_references) return;
             const Server echo({setup.reference_program("echo")});
             add_memory("echo", echo.process(), echo.port(), setup.subscribers, figures);
           },
           [&] {
             const Daemon daemon(setup.daemon());
             add_memory("daemon", daemon.process(), daemon.port(), setup.subscribers, figures);
           }});
}

void measure_start(const Setup& setup, Figures& figures) {
  const auto begun = std::chrono::steady_clock::now();
  const Daemon daemon(setup.daemon());
  Client client(daemon.port());
  const std::string response = client.call(R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse",)"
                                           R"("params":{"direction":"left"}})"
                                           "\n");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  if (response.find(R"("accepted":true)") == response.npos)
    throw std::runtime_error("the first pulse was not accepted: " + response);
  figures["start daemon ms"] = 1e3 * took.count();
}

void measure_plant_hour(const Setup& setup, Figures& figures) {
  const std::string program = setup.measured_program("plant_hour");
  if (!has(program, "plant hour_s", figures)) return;
  const long ticks = std::lround(std::ceil(kPlantTicksS * setup.seconds));
  const std::vector<double> seconds = numbers_of({program, std::to_string(ticks)});
  figures["plant hour_s"] = seconds[0];
  figures["plant alone_s"] = seconds[1];
}

void measure_client(const Setup& setup, Figures& figures) {
  const std::string program = setup.measured_program("client_cost");
  if (!has(program, "client own_us", figures)) return;
  const Server sender({setup.reference_program("telemetry_sender"), kNotificationsHz});
  const std::vector<double> costs_us =
      numbers_of({program, std::to_string(sender.port()), std::to_string(setup.seconds)});
  figures["client own_us"] = costs_us[0] - costs_us[1];
  figures["client socket_us"] = costs_us[1];
}

}  // namespace hedgehog::bench
