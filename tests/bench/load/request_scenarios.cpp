// SPDX-License-Identifier: MIT
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/load/child.h"
#include "tests/bench/load/client.h"
#include "tests/bench/load/crowd.h"
#include "tests/bench/load/daemon.h"
#include "tests/bench/load/scenarios.h"
#include "tests/bench/load/server.h"
#include "tests/free_port.h"
#include "tests/temporary_folder.h"

namespace hedgehog::bench {
namespace {

constexpr std::size_t kInFlight = 32;
Server echo(const Setup& setup) { return Server({setup.reference_program("echo")}); }
Server parsing_echo(const Setup& setup) {
  return Server({setup.reference_program("echo"), "--parse"});
}

void add_round_trips(const std::string& name, const Child& server, double seconds,
                     const std::function<void()>& one, Figures& figures) {
  round_trips(one, kWarmUpShare * seconds);
  const double before_s = server.cpu_s();
  const std::vector<double> took_s = round_trips(one, seconds);
  const double spent_s = server.cpu_s() - before_s;
  figures["ping " + name + " p50_us"] = 1e6 * quantile(took_s, 0.5);
  figures["ping " + name + " cpu_us"] = 1e6 * spent_s / static_cast<double>(took_s.size());
}

void ping(const std::string& name, const Child& server, int port, double seconds,
          Figures& figures) {
  Client client(port);
  add_round_trips(
      name, server, seconds, [&] { client.call(kPing); }, figures);
}

/// The same command with stderr discarded.
std::vector<std::string> quiet(std::vector<std::string> words) {
  const std::vector<std::string> shell{"sh", "-c", R"(exec "$0" "$@" 2>/dev/null)"};
  words.insert(words.begin(), shell.begin(), shell.end());
  return words;
}

/// Empty if the program is not installed.
std::string program_or_reason(const std::string& program, const std::string& figure,
                              Figures& figures) {
  std::string path = installed(program);
  if (path.empty()) figures.left_out[figure] = program + " is not installed";
  return path;
}

void ping_gpsd(const Setup& setup, Figures& figures) {
  const std::string path = program_or_reason("gpsd", "ping gpsd p50_us", figures);
  if (path.empty()) return;
  const int port = free_port();
  const TemporaryFolder folder;
  const Child server(quiet({path, "-N", "-S", std::to_string(port), "-F", folder.path("control")}));
  Client client = connect_when_listening(port);
  client.line();
  add_round_trips(
      "gpsd", server, setup.seconds, [&] { client.call("?VERSION;\n"); }, figures);
}

void ping_mosquitto(const Setup& setup, Figures& figures) {
  const std::string path = program_or_reason("mosquitto", "ping mosquitto p50_us", figures);
  if (path.empty()) return;
  const int port = free_port();
  const Child server(quiet({path, "-p", std::to_string(port)}));
  Client client = connect_when_listening(port);
  // MQTT 3.1.1: CONNECT of client "b" with a keep-alive of a minute; CONNACK has four bytes.
  using namespace std::string_view_literals;
  client.send("\x10\x0d\0\x04MQTT\x04\x02\0\x3c\0\x01"sv);
  client.send("b"sv);
  client.skip(4);
  const auto one = [&] {
    client.send("\xc0\0"sv);
    client.skip(2);
  };
  add_round_trips("mosquitto", server, setup.seconds, one, figures);
}

/// Responses per second of the server's processor time.
void load(const std::string& name, const Child& server, int port, std::size_t clients,
          std::size_t in_flight, double seconds, Figures& figures) {
  Crowd crowd(port, clients, in_flight);
  crowd.run(kWarmUpShare * seconds);
  const double before_s = server.cpu_s();
  const std::size_t responses = crowd.run(seconds);
  figures[name] = static_cast<double>(responses) / (server.cpu_s() - before_s);
}

void load_all(const Setup& setup, const std::string& scenario, std::size_t clients,
              std::size_t in_flight, Figures& figures) {
  const auto one = [&](const char* name, const auto& server) {
    load(scenario + " " + name, server.process(), server.port(), clients, in_flight, setup.seconds,
         figures);
  };
  const bool all = setup.with_references;
  in_turn(setup.round, {[&] {
                          if (all) one("echo", echo(setup));
                        },
                        [&] {
                          if (all) one("parse", parsing_echo(setup));
                        },
                        [&] { one("daemon", Daemon(setup.daemon())); }});
}

}  // namespace

void measure_ping(const Setup& setup, Figures& figures) {
  const auto one = [&](const char* name, const auto& server) {
    ping(name, server.process(), server.port(), setup.seconds, figures);
  };
  const bool all = setup.with_references;
  in_turn(setup.round, {[&] {
                          if (all) one("echo", echo(setup));
                        },
                        [&] {
                          if (all) one("parse", parsing_echo(setup));
                        },
                        [&] { one("daemon", Daemon(setup.daemon())); },
                        [&] {
                          if (all) ping_gpsd(setup, figures);
                        },
                        [&] {
                          if (all) ping_mosquitto(setup, figures);
                        }});
}

void measure_crowd(const Setup& setup, Figures& figures) {
  load_all(setup, "crowd", kCrowd, 1, figures);
}

void measure_pipelined(const Setup& setup, Figures& figures) {
  load_all(setup, "pipelined", 1, kInFlight, figures);
}

}  // namespace hedgehog::bench
