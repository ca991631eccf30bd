// SPDX-License-Identifier: MIT
#include "tests/bench/load/rows.h"

#include <array>
#include <cstdio>

namespace hedgehog::bench {
namespace {

Goal max_ratio(double bound) { return {Goal::Of::kRatio, true, bound}; }
Goal min_ratio(double bound) { return {Goal::Of::kRatio, false, bound}; }
Goal max_value(double bound) { return {Goal::Of::kValue, true, bound}; }
Goal min_value(double bound) { return {Goal::Of::kValue, false, bound}; }

std::vector<Row> request_rows() {
  const char* const echo = "Asio echo";
  const char* const parse = "nlohmann echo";
  return {
      {"ping, one client, p50", "us", "ping daemon p50_us", "ping echo p50_us", echo,
       max_ratio(1.12)},
      {"the same", "us", "ping daemon p50_us", "ping parse p50_us", parse, {}},
      {"the same, ?VERSION", "us", "ping daemon p50_us", "ping gpsd p50_us", "gpsd", {}},
      {"the same, PINGREQ", "us", "ping daemon p50_us", "ping mosquitto p50_us", "mosquitto", {}},
      {"ping, server's processor time", "us", "ping daemon cpu_us", "ping echo cpu_us", echo,
       max_ratio(1.25)},
      {"64 clients, requests/s a core", "1/s", "crowd daemon", "crowd parse", parse,
       min_ratio(1.3)},
      {"the same", "1/s", "crowd daemon", "crowd echo", echo, {}},
      {"32 in flight, requests/s a core", "1/s", "pipelined daemon", "pipelined parse", parse,
       min_ratio(2.2)},
      {"the same", "1/s", "pipelined daemon", "pipelined echo", echo, {}},
      {"pulse to its tick, p50", "tick", "pulse p50_ticks", "", "", max_value(0.6)},
      {"pulse to its tick, p99", "tick", "pulse p99_ticks", "", "", max_value(1.0)},
      {"the same, 64 clients ask, p50", "tick", "busy pulse p50_ticks", "", "", max_value(0.6)},
      {"the same, 64 clients ask, p99", "tick", "busy pulse p99_ticks", "", "", max_value(1.0)},
      {"pulse to board, p50", "tick", "pulse own p50_ticks", "", "", max_value(0.6)},
      {"pulse to board, p99 less lateness", "tick", "pulse own p99_ticks", "", "", max_value(1.0)},
      {"the same, 64 clients ask, p50", "tick", "busy pulse own p50_ticks", "", "", max_value(0.6)},
      {"the same, 64 clients ask, p99", "tick", "busy pulse own p99_ticks", "", "", max_value(1.0)},
  };
}

std::vector<Row> loop_rows() {
  std::vector<Row> rows;
  for (const auto& [scenario, text] : {std::pair{"lateness", "tick's lateness"},
                                       std::pair{"requests lateness", "the same, 64 clients ask"},
                                       std::pair{"stress lateness", "the same, stress-ng"}}) {
    for (const auto& [quantile, bound] : {std::pair{"p50", 1.2}, std::pair{"p99", 1.4}}) {
      const std::string of = std::string(scenario) + " ";
      const std::string figure = std::string(" ") + quantile + "_us";
      rows.push_back({std::string(text) + ", " + quantile, "us", of + "daemon" + figure,
                      of + "cyclictest" + figure, "cyclictest", max_ratio(bound)});
    }
  }
  rows.push_back({"processor a tick, 64 effects",
                  "us",
                  "work daemon tick_us",
                  "work loop tick_us",
                  "timer loop",
                  {}});
  rows.push_back(
      {"the same without the timer loop's", "us", "work daemon own_us", "", "", max_value(5.0)});
  rows.push_back({"idle with a client, of a core", "%", "idle daemon percent", "idle loop percent",
                  "timer loop", max_value(4.0)});
  rows.push_back({"disarmed without client, of a core", "%", "idle daemon disarmed_percent",
                  "idle loop percent", "timer loop", max_value(2.0)});
  return rows;
}

std::vector<Row> program_rows() {
  return {
      {"subscribers at 100 Hz: rate", "Hz", "subscribers daemon hz", "subscribers sender hz",
       "shared buffer", min_value(99.5)},
      {"subscribers: missing", "%", "subscribers daemon missing_percent",
       "subscribers sender missing_percent", "shared buffer", max_value(0.0)},
      {"subscribers: processor of a core",
       "%",
       "subscribers daemon cpu_percent",
       "subscribers sender cpu_percent",
       "shared buffer",
       {}},
      {"subscribers: processor a notification", "us", "subscribers daemon cpu_us",
       "subscribers sender cpu_us", "shared buffer", max_ratio(0.7)},
      {"subscribers: ping meanwhile, p50", "us", "subscribers daemon ping_us", "", "",
       max_value(1000.0)},
      {"subscribers: tick's lateness, p99", "us", "subscribers daemon lateness_p99_us",
       "lateness daemon p99_us", "without them", max_ratio(1.4)},
      {"memory resident", "MB", "memory daemon mb", "memory echo mb", "Asio echo", max_value(12.0)},
      {"memory a connection", "kB", "memory daemon connection_kb", "memory echo connection_kb",
       "Asio echo", max_value(6.0)},
      {"start to first accepted pulse", "ms", "start daemon ms", "", "", max_value(50.0)},
      {"an hour of plant to control", "s", "plant hour_s", "plant alone_s", "plant alone",
       max_value(5.0)},
      {"C++ client beyond its socket", "us", "client own_us", "client socket_us", "socket alone",
       max_value(3.0)},
  };
}

}  // namespace

std::string Goal::text() const {
  if (of == Of::kNothing) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%s %g%s", at_most ? "<=" : ">=", bound,
                of == Of::kRatio ? " x" : "");
  return text.data();
}

std::vector<Row> reference_rows() {
  std::vector<Row> rows = request_rows();
  for (const std::vector<Row>& more : {loop_rows(), program_rows()})
    rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

std::vector<Row> comparison_rows(const std::string& revision) {
  std::vector<Row> rows;
  for (Row row : reference_rows()) {
    // Skips the rows that only compare a figure with another reference.
    if (row.name.starts_with("the same") && row.name.find("clients") == row.name.npos &&
        row.name.find("stress") == row.name.npos)
      continue;
    row.reference = kOther + row.value;
    row.reference_name = revision;
    row.goal = {};
    rows.push_back(row);
  }
  return rows;
}

}  // namespace hedgehog::bench
