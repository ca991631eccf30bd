// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/heating.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "clients/common/interrupts.h"
#include "clients/ctl/calibrate/heat_bench.h"
#include "clients/ctl/calibrate/rest_check.h"
#include "clients/ctl/calibrate/winding_calibration.h"
#include "clients/ctl/terminal/words.h"
#include "model/identification/heating_plan.h"

namespace hedgehog::client {
namespace {

constexpr double kReportPeriodS = 10.0;

/// Progress display of a run.
class HeatingScreen {
 public:
  HeatingScreen(bool json, double total_s) : json_(json), total_s_(total_s) {
    drawn_ = !json && isatty(STDOUT_FILENO) != 0;
  }
  void show(std::string_view phase, double done_s, const model::HeatSample& sample) {
    const double sensor_c = sample.sensor_c.value_or(NAN);
    if (json_) {
      if (done_s < next_s_) return;
      next_s_ = done_s + kReportPeriodS;
      std::puts(nlohmann::json{{"phase", phase},
                               {"done_s", std::round(done_s)},
                               {"total_s", std::round(total_s_)},
                               {"sensor_c", std::round(10.0 * sensor_c) / 10.0},
                               {"fan", sample.fan_running}}
                    .dump()
                    .c_str());
    } else if (drawn_) {
      std::printf("\r  %s  %s of %s min  %s  %s °C   ", bar(done_s).c_str(),
                  right(fixed(std::floor(done_s / 60.0), 0), 2).c_str(),
                  fixed(std::ceil(total_s_ / 60.0), 0).c_str(), left(phase, 21).c_str(),
                  fixed(sensor_c, 1).c_str());
    } else if (phase != phase_) {
      std::printf("  minute %s of %s: %s\n", fixed(std::floor(done_s / 60.0), 0).c_str(),
                  fixed(std::ceil(total_s_ / 60.0), 0).c_str(), std::string(phase).c_str());
    }
    phase_ = phase;
    std::fflush(stdout);
  }
  void end() const {
    if (drawn_) std::puts("");
  }

 private:
  std::string bar(double done_s) const {
    constexpr int kColumns = 24;
    const int full = static_cast<int>(std::lround(kColumns * std::min(1.0, done_s / total_s_)));
    std::string text = "[";
    for (int k = 0; k < kColumns; ++k) text += k < full ? "#" : ".";
    return text + "]";
  }

  bool json_;
  bool drawn_ = false;
  double total_s_;
  double next_s_ = 0.0;
  std::string_view phase_;
};

int stopped(const ClientError& error, const HeatProgressFile& file) {
  if (interrupted())
    std::fputs("hedgehogctl calibrate: interrupted; the coils are off. ", stderr);
  else
    report_error(error);
  std::fprintf(stderr, "Repeat the command to resume from %s.\n", file.path().c_str());
  return interrupted() ? static_cast<int>(kInterrupted) : exit_code_of(error);
}

void print_found(const model::ThermalFound& found) {
  const auto value = [](const char* name, double is, double share, const char* unit) {
    std::printf("  %s %s %s  ± %s %%\n", left(name, 22).c_str(), right(fixed(is, 2), 7).c_str(),
                unit, fixed(100.0 * share, 1).c_str());
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string winding = std::string("winding ") + "xyz"[i];
    value(winding.c_str(), found.thermal.winding_j_k[i], found.deviation.winding_j_k[i], "J/K");
    value("  to the core", found.thermal.winding_to_core_k_w[i],
          found.deviation.winding_to_core_k_w[i], "K/W");
  }
  value("core", found.thermal.core_j_k, found.deviation.core_j_k, "J/K");
  value("  to the room, fan", found.thermal.core_to_ambient_fan_k_w,
        found.deviation.core_to_ambient_fan_k_w, "K/W");
  value("  to the room, no fan", found.thermal.core_to_ambient_still_k_w,
        found.deviation.core_to_ambient_still_k_w, "K/W");
  std::printf("  The thermometer is on winding %c, lag %s s%s.\n",
              "xyz"[found.thermal.sensor_winding], fixed(found.thermal.sensor_lag_s, 1).c_str(),
              found.sensor_certain ? "" : " (not certain)");
}

}  // namespace

int heat_and_cool(Session& session, const protocol::Description& ball, HeatProgressFile& file,
                  HeatProgress& progress) {
  const auto plan = model::heating_plan(ball.limits.current_a);
  std::size_t step = resumed_step(plan, progress.next_step);
  if (step == plan.size()) return kDone;
  HeatingScreen screen(session.json, model::duration_s(plan));
  double done_s = 0.0;
  for (std::size_t k = 0; k < step; ++k) done_s += plan[k].duration_s;
  std::fprintf(session.json ? stderr : stdout,
               "%s and cooling for %s minutes: on a table, in still air, not in a hand.\n"
               "Ctrl-C interrupts; repeat the command to resume.\n",
               step == 0 ? "Heating" : "Resuming heating",
               fixed(std::ceil((model::duration_s(plan) - done_s) / 60.0), 0).c_str());
  HeatBench bench(session, ball.coils);
  if (auto begun = bench.begin(); !begun) return stopped(begun.error(), file);
  const std::size_t run = progress.runs.size();
  progress.runs.emplace_back();
  progress.runs.back().began_at_rest = run == 0 && step == 0;
  for (; step < plan.size(); ++step) {
    auto sample = bench.run(plan[step]);
    if (!sample) {
      screen.end();
      return stopped(sample.error(), file);
    }
    progress.runs[run].samples.push_back(*sample);
    progress.next_step = step + 1;
    file.add(*sample, progress.runs[run].began_at_rest, run, step);
    done_s += plan[step].duration_s;
    screen.show(plan[step].phase, done_s, *sample);
  }
  screen.end();
  if (auto ended = bench.end(); !ended) return stopped(ended.error(), file);
  return kDone;
}

int fit_heat(const Session& session, const HeatProgress& progress,
             const protocol::Description& ball, Calibration& found) {
  const auto thermal = model::fit_thermal(progress.runs, progress.windings.r25_ohm, ball.thermal);
  if (!thermal) {
    return print_error(
        "what was measured does not fit a ball of three windings around a core to 20 %: was it "
        "moved, held, or in a draught? Remove the .progress file and start over");
  }
  found.thermal = thermal;
  if (!session.json) print_found(*thermal);
  return kDone;
}

}  // namespace hedgehog::client
