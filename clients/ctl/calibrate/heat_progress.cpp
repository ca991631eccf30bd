// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/heat_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "base/parse_json.h"
#include "clients/ctl/calibrate/rest_check.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr double kMaxAmbientFallK = 3.0;

std::string header(const HeatProgress& progress) {
  const Calibration& w = progress.windings;
  const Json json{{"hedgehog_heating", kVersion},
                  {"ball", progress.ball},
                  {"name", w.name},
                  {"r25_ohm", w.r25_ohm},
                  {"inductance_h", w.inductance_h},
                  {"sensor_c", w.sensor_c},
                  {"current_a", w.current_a},
                  {"supply_v", w.supply_v},
                  {"pushed", w.pushed.side},
                  {"resistance_share", w.resistance_share},
                  {"unrest", w.unrest},
                  {"apart_k", w.apart_k}};
  return json.dump();
}

std::string line_of(const model::HeatSample& s, std::size_t run, bool at_rest, std::size_t step) {
  Json json{{"run", run},
            {"at_rest", at_rest},
            {"step", step},
            {"dt_s", s.dt_s},
            {"end_s", s.end_s},
            {"power_w", s.power_w},
            {"voltage_v", s.voltage_v},
            {"current_a", s.current_a},
            {"count", s.count},
            {"fan", s.fan_running}};
  if (s.sensor_c) json["sensor_c"] = *s.sensor_c;
  return json.dump();
}

HeatProgress read_header(const Json& json) {
  HeatProgress progress;
  progress.ball = json.at("ball").get<std::string>();
  Calibration& w = progress.windings;
  w.name = json.at("name").get<std::string>();
  w.r25_ohm = json.at("r25_ohm").get<std::array<double, 3>>();
  w.inductance_h = json.at("inductance_h").get<std::array<double, 3>>();
  w.sensor_c = json.at("sensor_c").get<double>();
  w.current_a = json.at("current_a").get<double>();
  w.supply_v = json.at("supply_v").get<double>();
  w.pushed.side = json.at("pushed").get<std::array<std::string, 3>>();
  w.resistance_share = json.at("resistance_share").get<double>();
  w.unrest = json.at("unrest").get<std::string>();
  w.apart_k = json.at("apart_k").get<double>();
  return progress;
}

void read_sample(const Json& json, HeatProgress& progress) {
  const auto run = json.at("run").get<std::size_t>();
  if (run > progress.runs.size()) throw Json::other_error::create(501, "a run is missing", nullptr);
  if (run == progress.runs.size()) {
    progress.runs.emplace_back();
    progress.runs.back().began_at_rest = json.at("at_rest").get<bool>();
  }
  model::HeatSample s;
  s.dt_s = json.at("dt_s").get<double>();
  s.end_s = json.at("end_s").get<double>();
  s.power_w = json.at("power_w").get<std::array<double, 3>>();
  s.voltage_v = json.at("voltage_v").get<std::array<double, 3>>();
  s.current_a = json.at("current_a").get<std::array<double, 3>>();
  s.count = json.at("count").get<int>();
  s.fan_running = json.at("fan").get<bool>();
  if (json.contains("sensor_c")) s.sensor_c = json.at("sensor_c").get<double>();
  progress.runs[run].samples.push_back(s);
  progress.next_step = json.at("step").get<std::size_t>() + 1;
}

}  // namespace

std::string identity_of(const protocol::Description& ball) {
  std::ostringstream text;
  text << ball.name << ' ' << ball.board.backend << ' ' << ball.board.serial.value_or("-");
  for (const double ohm : ball.coils.r25_ohm) text << ' ' << ohm;
  return text.str();
}

std::optional<HeatProgress> read_progress(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  try {
    if (!std::getline(lines, line)) return std::nullopt;
    const auto first = base::parse_json<Json>(line);
    if (!first.good() || first.value.at("hedgehog_heating").get<int>() != kVersion)
      return std::nullopt;
    HeatProgress progress = read_header(first.value);
    while (std::getline(lines, line)) {
      const auto sample = base::parse_json<Json>(line);
      if (!sample.good()) break;
      read_sample(sample.value, progress);
    }
    return progress;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string incompatible(const HeatProgress& progress, const protocol::Description& ball,
                         const protocol::TemperatureStatus& now) {
  if (progress.ball != identity_of(ball))
    return "it was measured on another ball, or with another device file in force";
  const double cooler_k = progress.windings.sensor_c - reference_c(now);
  if (cooler_k > kMaxAmbientFallK)
    return "the ball is " + fixed(cooler_k, 1) +
           " K cooler than at its start: the ambient temperature has changed";
  return {};
}

std::size_t resumed_step(const std::vector<model::HeatingStep>& plan, std::size_t next_step) {
  std::size_t step = std::min(next_step, plan.size());
  if (step == plan.size()) return step;
  while (step > 0 && plan[step - 1].phase == plan[step].phase) --step;
  return step;
}

HeatProgressFile::HeatProgressFile(std::string path, const HeatProgress& progress)
    : path_(std::move(path)) {
  // The old file stays until the new one is complete.
  const std::string unfinished = path_ + ".new";
  file_.open(unfinished, std::ios::trunc);
  file_ << header(progress) << '\n';
  // Their steps are only used to resume, so that the last one suffices.
  const std::size_t last_step = progress.next_step == 0 ? 0 : progress.next_step - 1;
  for (std::size_t run = 0; run < progress.runs.size(); ++run)
    for (const model::HeatSample& sample : progress.runs[run].samples)
      file_ << line_of(sample, run, progress.runs[run].began_at_rest, last_step) << '\n';
  file_.flush();
  if (std::rename(unfinished.c_str(), path_.c_str()) != 0) file_.setstate(std::ios::failbit);
}

void HeatProgressFile::add(const model::HeatSample& sample, bool began_at_rest, std::size_t run,
                           std::size_t step) {
  file_ << line_of(sample, run, began_at_rest, step) << '\n' << std::flush;
}

void HeatProgressFile::remove() {
  file_.close();
  std::remove(path_.c_str());
}

}  // namespace hedgehog::client
