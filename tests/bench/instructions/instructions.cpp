// SPDX-License-Identifier: MIT
// Repeats one operation inside the process: server, controller, link and simulated board on virtual
// time, no socket, no thread. `instructions WHAT TIMES`; callgrind counts what `hedgehog_counted`
// calls (check.sh).
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "tests/server/server_rig.h"

/// A name that callgrind's --toggle-collect finds.
extern "C" [[gnu::noinline]] void hedgehog_counted(const std::function<void()>& work) { work(); }

namespace hedgehog::server {
namespace {

constexpr int kWarmUp = 100;
/// Ticks until a pulse of 5 ms has ended and its slot is free again.
constexpr int kPulseTicks = 10;

constexpr const char* kPing = R"({"jsonrpc":"2.0","id":1,"method":"ping"})";
constexpr const char* kStatus = R"({"jsonrpc":"2.0","id":1,"method":"device.status"})";
constexpr const char* kPulse = R"({"jsonrpc":"2.0","id":1,"method":"effect.pulse",)"
                               R"("params":{"direction":"left","current_a":5,"duration_ms":5}})";
constexpr const char* kHold = R"({"jsonrpc":"2.0","id":1,"method":"effect.hold",)"
                              R"("params":{"direction":[1,2,3],"current_a":5,"lease_ms":10000}})";
constexpr const char* kSubscribe =
    R"({"jsonrpc":"2.0","id":1,"method":"telemetry.subscribe",)"
    R"("params":{"rate_hz":100,"fields":["state","temperature_c","current_a"]}})";

class CountedRig {
 public:
  void requests(const char* line, int ticks) {
    count_if_enabled([&] { rig_.server->line(client_.session, line); });
    for (int i = 0; i < ticks; ++i) tick([&](auto run) { run(); }, [&](auto pump) { pump(); });
    client_.lines.clear();
  }
  void control_tick() {
    tick([&](auto run) { count_if_enabled(run); }, [&](auto pump) { pump(); });
  }
  void server_pump() {
    tick([&](auto run) { run(); }, [&](auto pump) { count_if_enabled(pump); });
    client_.lines.clear();
  }
  void send(const char* line) {
    rig_.server->line(client_.session, line);
    client_.lines.clear();
  }
  void count() { counts_ = true; }
  bool is_armed() const { return rig_.device_view->now().state == control::State::kArmed; }

 private:
  void count_if_enabled(const std::function<void()>& work) {
    if (counts_)
      hedgehog_counted(work);
    else
      work();
  }
  template <class Run, class Pump>
  void tick(Run run, Pump pump) {
    run([&] { rig_.control->run(++tick_, 0, {}); });
    rig_.world.step();
    pump([&] { rig_.server->pump(); });
  }

  ServerRig rig_;
  FakeClient& client_ = rig_.connect();
  model::Tick tick_ = 1000;
  bool counts_ = false;
};

/// The operations that can be counted, each executed once.
const std::map<std::string, std::function<void(CountedRig&)>>& cases() {
  static const std::map<std::string, std::function<void(CountedRig&)>> kAll{
      {"ping", [](CountedRig& c) { c.requests(kPing, 0); }},
      {"device.status", [](CountedRig& c) { c.requests(kStatus, 0); }},
      {"effect.pulse", [](CountedRig& c) { c.requests(kPulse, kPulseTicks); }},
      {"tick", [](CountedRig& c) { c.control_tick(); }},
      {"pump", [](CountedRig& c) { c.server_pump(); }},
  };
  return kAll;
}

int run(const std::string& what, int times) {
  const auto found = cases().find(what);
  if (found == cases().end() || times < 1) {
    std::cerr << "instructions WHAT TIMES; WHAT:";
    for (const auto& [name, work] : cases()) std::cerr << ' ' << name;
    std::cerr << '\n';
    return EXIT_FAILURE;
  }
  CountedRig counting;
  // Ticks and pumps are counted with an active effect and a subscribed client.
  if (what == "tick") counting.send(kHold);
  if (what == "pump") counting.send(kSubscribe);
  for (int i = 0; i < kWarmUp; ++i) found->second(counting);
  counting.count();
  for (int i = 0; i < times; ++i) found->second(counting);
  if (!counting.is_armed()) std::cerr << "instructions: the ball is not armed any more\n";
  return counting.is_armed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace hedgehog::server

int main(int argc, char** argv) {
  return hedgehog::server::run(argc == 3 ? argv[1] : "", argc == 3 ? std::atoi(argv[2]) : 0);
}
