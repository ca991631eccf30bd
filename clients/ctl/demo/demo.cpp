// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/demo.h"

#include <cstdio>
#include <memory>

#include "clients/common/interrupts.h"
#include "clients/common/terminal.h"
#include "clients/ctl/demo/private_daemon.h"
#include "clients/ctl/demo/tour_player.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

/// "A ball in mid-game": from here a 15 A push reaches the derating within the tour. The ambient is
/// so cold that the shell of a ball that warm may still be held.
constexpr double kWarmStartC = 52.0;
constexpr double kColdAmbientC = 0.0;

bool confirm_holder(const Ball& ball) {
  std::printf(
      "%s is a real ball. Up to 15 A will flow for some seconds: hold it with both hands.\n"
      "Enter plays the tour, Ctrl-C leaves it. ",
      ball.status.device.c_str());
  std::fflush(stdout);
  const int key = std::getchar();
  return key == '\n' && !interrupted();
}

void print_summary(const TourRecord& record, const model::Limits& limits,
                   const protocol::Status& last, double seconds) {
  std::printf("\n %s s: 6 pulses, a circle, a skid, a compass, one long push. All coils are off.\n",
              fixed(seconds, 0).c_str());
  const bool derated = record.min_limit_a() < limits.current_a;
  std::printf(" Hottest winding %s °C (trips at %s). The long push was %s.\n",
              fixed(record.hottest_c(), 1).c_str(), fixed(limits.trip_c, 0).c_str(),
              derated ? ("derated to " + fixed(record.min_limit_a(), 1) + " A, never cut").c_str()
                      : "never derated");
  const protocol::LoopStatus& loop = last.loop;
  std::printf(" %s ticks, %s skipped, latest %s ms.\n\n",
              grouped(static_cast<double>(loop.ticks)).c_str(),
              loop.skipped == 0 ? "none" : grouped(static_cast<double>(loop.skipped)).c_str(),
              fixed(loop.lateness_us.max / 1000.0, 2).c_str());
}

void print_next() {
  std::puts("   make run                  a simulated ball to look at, http://127.0.0.1:7587");
  std::puts("   make race                 hedgehog-racer, a game, http://127.0.0.1:7585");
  std::puts("   hedgehogctl pulse left    push the left palm yourself");
  std::puts("   clients/README.md         ten lines in C++, and in other languages");
}

int play(Session& session, const DemoOptions& options) {
  auto ball = look(session.connection);
  if (!ball) return report_error(ball.error());
  if (!ball->status.simulated && !options.confirmed && !confirm_holder(*ball)) return kInterrupted;
  TourPlayer player(session.connection, *ball, session.style);
  const auto outcome = player.play();
  if (!outcome) return report_error(outcome.error());
  if (interrupted()) {
    std::fputs("hedgehogctl: interrupted; the coils are off\n", stderr);
    return kInterrupted;
  }
  const auto last = session.connection.call(protocol::DeviceStatus{});
  if (!last) return report_error(last.error());
  const std::vector<std::string> failures =
      player.record().failures(*last, player.began_ns(), options.private_daemon);
  for (const std::string& failure : failures) print_failure("failed", "demo: " + failure);
  if (!failures.empty()) return kEndedOtherwise;
  print_summary(player.record(), player.limits(), *last, player.seconds());
  print_next();
  return kDone;
}

}  // namespace

int run_demo(const CommonOptions& common, const DemoOptions& options) {
  CommonOptions chosen = common;
  std::unique_ptr<PrivateDaemon> daemon;
  if (options.private_daemon) {
    auto started = PrivateDaemon::start(kWarmStartC, kColdAmbientC);
    if (!started) {
      print_failure("no_daemon", started.error().message);
      return kUnavailable;
    }
    daemon = std::make_unique<PrivateDaemon>(*std::move(started));
    chosen.address = daemon->socket();
  }
  int code = kUnavailable;
  {
    auto session = open_session(chosen);
    code = session ? play(*session, options) : static_cast<int>(report_error(session.error()));
  }
  if (daemon != nullptr && daemon->stop() != 0 && code == kDone) {
    print_failure("failed", "demo: its daemon did not end cleanly");
    code = kEndedOtherwise;
  }
  return code;
}

}  // namespace hedgehog::client
