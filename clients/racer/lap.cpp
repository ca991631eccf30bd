// SPDX-License-Identifier: MIT
#include "clients/racer/lap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "clients/common/exit_code.h"
#include "clients/racer/feel/feel.h"
#include "clients/racer/game/driver.h"
#include "clients/racer/game/race.h"
#include "clients/racer/pace.h"
#include "clients/racer/race_event_text.h"

namespace hedgehog::racer {

namespace {

constexpr int kTripped = 1;
constexpr std::chrono::milliseconds kArrives{5000};

struct Count {
  double driven_s = 0.0;
  int laps = 0;
  std::optional<double> best_lap_s{};
  int hits = 0;
  int landings = 0;
  double skid_s = 0.0;
  double tumble_s = 0.0;

  void take(const RaceEvent& race_event) {
    if (std::holds_alternative<Hit>(race_event)) ++hits;
    if (std::holds_alternative<Landing>(race_event)) ++landings;
    if (std::holds_alternative<LapDone>(race_event)) ++laps;
    if (std::holds_alternative<Skid>(race_event)) skid_s += Race::kStepS;
    if (std::holds_alternative<Tumble>(race_event)) tumble_s += Race::kStepS;
  }
};

bool is_ready(const BallReport& ball) {
  return ball.connected && ball.state == "armed" && ball.problem.empty();
}

/// Maximum waiting time for a ball that is not ready. If a daemon exists: the response timeout.
std::chrono::milliseconds max_wait(const BallReport& ball) {
  const bool may_answer = ball.late || ball.problem.empty();
  return may_answer ? std::max(kArrives, client::response_timeout()) : kArrives;
}

/// Why the ball is not usable; nullopt: it is ready. Waits only while it may still become ready.
std::optional<std::string> wait_for(Feel& feel) {
  const auto begun = std::chrono::steady_clock::now();
  for (;;) {
    feel.frame({}, 0.0);
    const BallReport& ball = feel.ball();
    if (is_ready(ball)) return std::nullopt;
    const std::string why = sentence(ball);
    if (!why.empty() && !ball.late) return why;
    if (std::chrono::steady_clock::now() - begun > max_wait(ball))
      return why.empty() ? "the daemon does not answer" : why;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// Why the ball was lost during the race; nullopt: it is connected. Waits for a silent daemon to
/// resume.
std::optional<std::string> lost(Feel& feel, double time_s) {
  const auto begun = std::chrono::steady_clock::now();
  for (;;) {
    feel.frame({}, time_s);
    const BallReport& ball = feel.ball();
    if (is_ready(ball)) return std::nullopt;
    const bool over = std::chrono::steady_clock::now() - begun > max_wait(ball);
    if (ball.connected || over) return sentence(ball);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// True if the ball is claimed by another client: nothing was felt and nothing will be.
bool is_claimed(const Feel& feel) {
  return feel.ball().connected && !feel.ball().problem.empty() && feel.summary().pulses == 0;
}

/// Waits for the responses to the last blows; a daemon that becomes silent sends none.
void await_responses(Feel& feel, double time_s) {
  const auto until = std::chrono::steady_clock::now() + client::response_timeout();
  while (!feel.all_answered() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    feel.frame({}, time_s);
  }
}

void print_reason(const std::string& why) {
  std::fprintf(stderr, "hedgehog-racer: %s (lap --no-ball drives without a ball)\n", why.c_str());
}

std::string number(const std::optional<double>& value) {
  return value ? std::to_string(*value) : "null";
}

void print_json(const Count& count, const Feel* feel) {
  std::printf(R"({"type":"summary","driven_s":%.2f,"laps":%d,"best_lap_s":%s,"hits":%d,)",
              count.driven_s, count.laps, number(count.best_lap_s).c_str(), count.hits);
  std::printf(R"("landings":%d,"skid_s":%.2f,"tumble_s":%.2f,"ball":)", count.landings,
              count.skid_s, count.tumble_s);
  if (feel == nullptr) {
    std::puts("null}");
    return;
  }
  const BallSummary& ball = feel->summary();
  std::printf(R"({"pulses":%d,"refused":%d,"left_out":%d,"turned_down_s":%.2f,"least_gain":%.3f,)",
              ball.pulses, ball.refused, ball.left_out, ball.turned_down_s, ball.min_gain);
  std::printf(R"("derated_s":%.2f,"least_limit_a":%s,"hottest_c":%s,"tripped":%s}})",
              ball.derated_s, number(ball.min_limit_a).c_str(), number(ball.hottest_c).c_str(),
              ball.tripped ? "true" : "false");
  std::puts("");
}

void print(const Count& count, const Feel* feel) {
  std::printf("driven        %.0f s, %d laps", count.driven_s, count.laps);
  if (count.best_lap_s) std::printf(", the best in %.2f s", *count.best_lap_s);
  std::printf("\nhappened      %d hits, %d landings, %.1f s of skidding", count.hits,
              count.landings, count.skid_s);
  if (count.tumble_s > 0.0) std::printf(", %.1f s of turning over", count.tumble_s);
  std::puts("");
  if (feel == nullptr) return;
  const BallSummary& ball = feel->summary();
  std::printf("felt          %d pulses; %d more were too soon after one as hard\n", ball.pulses,
              ball.left_out);
  if (ball.refused > 0) std::printf("not felt      %d pulses rejected\n", ball.refused);
  std::printf("turned down   by the game for %.1f s, at the least to %.0f %%\n", ball.turned_down_s,
              100.0 * ball.min_gain);
  std::printf("derated       by the daemon for %.1f s; never below %.1f A allowed\n",
              ball.derated_s, ball.min_limit_a.value_or(0.0));
  std::printf("hottest       %.1f °C, %s\n", ball.hottest_c.value_or(0.0),
              ball.tripped ? "and the ball tripped" : "never tripped");
}

}  // namespace

int drive_laps(const LapOptions& options, const std::function<bool()>& interrupted) {
  std::unique_ptr<Feel> feel;
  if (!options.addresses.empty()) {
    feel = std::make_unique<Feel>(options.addresses);
    if (const auto why_not = wait_for(*feel)) {
      print_reason(*why_not);
      return kUnavailable;
    }
  }
  Race race(home_track());
  Driver driver;
  RaceEventLog log;
  Count count;
  Pace pace(options.speed);
  const long steps = std::lround(options.seconds / Race::kStepS);
  for (long step = 0; step < steps && !interrupted(); ++step) {
    const Scene& scene = race.step(driver.drive(race.scene(), race.track()));
    if (feel) feel->frame(race.race_events(), scene.time_s);
    for (const RaceEvent& race_event : race.race_events()) {
      count.take(race_event);
      if (options.json) std::puts(to_json(race_event, scene.time_s).c_str());
    }
    if (!options.json)
      for (const std::string& line : log.lines(race.race_events(), scene.time_s))
        std::puts(line.c_str());
    std::fflush(stdout);
    if (feel && is_claimed(*feel)) {
      print_reason(feel->ball().problem);
      return kUnavailable;
    }
    if (feel) pace.wait();
  }
  count.driven_s = race.scene().time_s;
  count.best_lap_s = race.scene().best_lap_s;
  std::optional<std::string> lost_reason;
  if (feel && !interrupted()) lost_reason = lost(*feel, count.driven_s);
  if (feel) {
    await_responses(*feel, count.driven_s);
    feel->pause();
  }
  options.json ? print_json(count, feel.get()) : print(count, feel.get());
  if (interrupted()) return kInterrupted;
  if (feel && feel->summary().tripped) return kTripped;
  if (lost_reason) print_reason(*lost_reason);
  return lost_reason ? kUnavailable : 0;
}

}  // namespace hedgehog::racer
