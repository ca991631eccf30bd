// SPDX-License-Identifier: MIT
#include "clients/racer/drive.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "clients/common/exit_code.h"
#include "clients/racer/best_lap.h"
#include "clients/racer/feel/feel.h"
#include "clients/racer/game/driver.h"
#include "clients/racer/game/race.h"
#include "clients/racer/game/tilt.h"
#include "clients/racer/pace.h"
#include "clients/racer/server/server.h"

namespace hedgehog::racer {
namespace {

/// Interval of lasting effects and of the ball's status, frames: ten per second.
constexpr int kSeldom = 6;
/// Burst time of a cold ball at full strength, s.
constexpr double kColdBurstS = 22.0;

bool lasts(const Played& played) {
  const std::string_view what = played.kind;
  return what == "skid" || what == "tumble";
}

BallView view_of(const BallReport& ball) {
  BallView view;
  view.connected = ball.connected;
  view.simulated = ball.simulated;
  view.state = ball.state;
  view.gain = ball.gain;
  view.reason = ball.problem;
  if (ball.connected) {
    view.temperature_c = ball.temperature_c;
    view.limit_a = ball.limit_a;
    view.budget = ball.burst_s ? std::clamp(*ball.burst_s / kColdBurstS, 0.0, 1.0) : 1.0;
    view.derated = ball.derating;
    if (ball.state != "armed") {
      view.reason =
          "The ball is " + ball.state + "." + (ball.remedy.empty() ? "" : " ") + ball.remedy;
    }
  }
  return view;
}

/// Prints changes of the ball's status to the terminal.
class StatusLine {
 public:
  void publish(const BallReport& ball) {
    std::string text = sentence(ball);
    if (!ball.connected && !text.empty()) text += "; driving works without a ball";
    if (text.empty() || text == reported_) return;
    reported_ = text;
    std::puts(reported_.c_str());
    std::fflush(stdout);
  }

 private:
  std::string reported_;
};

class Drive {
 public:
  explicit Drive(const DriveOptions& options)
      : race_(home_track()),
        server_(options.page, race_.track()),
        mode_(options.mode.value_or(Mode::kKeyboard)),
        chosen_(options.mode.has_value()),
        uses_ball_(!options.addresses.empty()),
        feel_(options.addresses) {}

  void run(const std::function<bool()>& interrupted) {
    Pace pace(1.0);
    while (!interrupted()) {
      frame();
      server_.serve_until(pace.next());
    }
    feel_.pause();
    server_.announce_shutdown("it was stopped");
  }
  std::uint16_t port() const noexcept { return server_.port(); }

 private:
  void frame();
  void apply(const PageRequests& asked);
  void set_mode(Mode mode);
  Controls controls(const PageRequests& asked);
  void publish(bool moved);
  void publish_laps();
  /// Orientation of the ball; nullopt: unknown.
  const std::optional<model::Quaternion>& held() const { return feel_.ball().orientation; }

  Race race_;
  Server server_;
  Driver driver_;
  Tilt tilt_;
  StatusLine status_line_;
  BestLap best_lap_;
  Mode mode_;
  bool chosen_;           // by the player
  bool centred_ = false;  // the orientation at the takeover by the ball is neutral
  bool uses_ball_;        // a ball is used; otherwise the page only shows what would be felt
  Feel feel_;
  bool paused_ = false;
  int frames_ = 0;
};

void Drive::set_mode(Mode mode) {
  mode_ = mode;
  driver_ = {};
  centred_ = false;
}

void Drive::apply(const PageRequests& asked) {
  // A player who drives by keyboard keeps control when a ball connects.
  if (asked.keys != Controls{}) chosen_ = true;
  if (asked.mode) {
    chosen_ = true;
    set_mode(*asked.mode);
  } else if (!chosen_ && held()) {
    chosen_ = true;
    set_mode(Mode::kBall);
  }
  if (asked.reset) {
    race_.recover();
    set_mode(mode_);
  }
  if (asked.pause && *asked.pause != paused_) {
    paused_ = *asked.pause;
    if (paused_) feel_.pause();
  }
}

Controls Drive::controls(const PageRequests& asked) {
  if (mode_ == Mode::kDriver) return driver_.drive(race_.scene(), race_.track());
  if (mode_ == Mode::kBall && held() && !centred_) {
    tilt_.recentre(*held());
    centred_ = true;
  }
  return mode_ == Mode::kBall && held() ? tilt_.controls(*held()) : asked.keys;
}

void Drive::frame() {
  const PageRequests asked = server_.take();
  apply(asked);
  if (!paused_) {
    best_lap_.drive(mode_ == Mode::kDriver);
    race_.step(controls(asked));
    publish_laps();
  }
  feel_.frame(paused_ ? std::vector<RaceEvent>{} : race_.race_events(), race_.scene().time_s);
  if (uses_ball_) status_line_.publish(feel_.ball());
  publish(!paused_);
  ++frames_;
}

void Drive::publish(bool moved) {
  const bool seldom = frames_ % kSeldom == 0;
  server_.publish(race_.scene(), {mode_, paused_, best_lap_.time_s()});
  if (seldom) server_.publish(uses_ball_ ? view_of(feel_.ball()) : BallView{});
  if (!moved) return;
  for (const Played& played : feel_.played()) {
    if (lasts(played) && !seldom) continue;
    server_.publish(Felt{played.kind, played.direction, played.current_a / played.full_a,
                         played.on_the_ball ? played.current_a : 0.0});
  }
}

void Drive::publish_laps() {
  for (const RaceEvent& race_event : race_.race_events()) {
    if (const auto* lap = std::get_if<LapDone>(&race_event)) {
      const bool by_driver = best_lap_.by_driver();
      server_.publish(FinishedLap{lap->lap, lap->time_s, best_lap_.finish(lap->time_s), by_driver});
    }
  }
}

}  // namespace

std::optional<HubSettings> listen_at(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return std::nullopt;
  HubSettings settings;
  settings.address = text.substr(0, colon);
  if (settings.address.starts_with('[') && settings.address.ends_with(']'))
    settings.address = settings.address.substr(1, settings.address.size() - 2);
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, settings.port);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return settings;
}

int drive(const DriveOptions& options, const std::function<bool()>& interrupted) {
  std::unique_ptr<Drive> game;
  try {
    game = std::make_unique<Drive>(options);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "hedgehog-racer: %s\n", error.what());
    return kCannotCreate;
  }
  const bool six = options.page.address.find(':') != std::string::npos;
  std::printf("http://%s%s%s:%u   open this in a browser; Ctrl-C ends the game\n", six ? "[" : "",
              options.page.address.c_str(), six ? "]" : "", unsigned{game->port()});
  std::fflush(stdout);
  game->run(interrupted);
  return 0;
}

}  // namespace hedgehog::racer
