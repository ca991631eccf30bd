// SPDX-License-Identifier: MIT
#include "tests/soak/round.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/e2e/programs.h"
#include "tests/soak/failure.h"

namespace hedgehog::soak {
namespace {

constexpr std::size_t kShownLog = 6000;

std::string tail(const std::string& text) {
  return text.size() <= kShownLog ? text : "..." + text.substr(text.size() - kShownLog);
}

/// The report of a sanitizer or of an assertion; empty: none.
std::string report_in(const std::string& log) {
  for (const char* report : {"ERROR: AddressSanitizer", "ERROR: LeakSanitizer", "runtime error:",
                             "WARNING: ThreadSanitizer", "terminate called", "Assertion"})
    if (const auto at = log.find(report); at != std::string::npos)
      return "A report on stderr:\n" + log.substr(log.rfind('\n', at) + 1, kShownLog) + "\n";
  return {};
}

void check_log(const std::string& log) {
  if (const std::string report = report_in(log); !report.empty()) throw Failure(report);
}

}  // namespace

Round::Round(std::uint64_t seed, RoundSize size, Summary& summary)
    : seed_(seed),
      size_(size),
      summary_(summary),
      random_(seed),
      draws_(seed),
      generator_(draws_),
      folder_(home_, may_mount() && random_.percent(40)) {}

void Round::run() {
  ++summary_.rounds;
  for (int start = 0; start < size_.starts; ++start) {
    try {
      run_start(start);
    } catch (const std::exception& e) {
      const std::string log = home_.read("log");
      throw Failure(std::string(e.what()) + "\nin start " + std::to_string(start + 1) +
                    " of the round. " + report_in(log) + "The log ends:\n" + tail(log));
    }
  }
}

void Round::run_start(int number) {
  const Configuration configuration = random_configuration(random_);
  const int plants = random_.percent(25) ? 1 + static_cast<int>(random_.below(3)) : 0;
  for (int i = 0; i < plants; ++i) {
    ++summary_.unusual_files;
    if (folder_.plant(random_)) inherited_ = {};
    inherited_.incomplete.clear();
    inherited_.orderly = false;
  }
  const bool lockstep = random_.percent(80);
  const std::string speed = std::to_string(e2e::attainable_speed(random_.percent(50) ? 4 : 1));
  const End how = static_cast<End>(random_.below(6));
  const bool with_full_disk = folder_.is_small_disk() && random_.percent(60);

  home_.configure(configuration.json);
  disk_was_full_ = false;
  using Backend = e2e::DaemonProcess::Backend;
  daemon_ =
      lockstep
          ? std::make_unique<e2e::DaemonProcess>(home_, std::vector<std::string>{"--speed", speed})
          : std::make_unique<e2e::DaemonProcess>(home_, std::vector<std::string>{},
                                                 std::vector<std::string>{}, Backend::kFree);
  ++summary_.starts;
  Traffic traffic(*daemon_, home_, generator_, summary_, configuration.current_a);
  try {
    check_start(traffic);
    Actions actions(draws_, generator_, traffic, seed_ * 1000 + static_cast<std::uint64_t>(number));
    act(traffic, actions, size_.actions / 2);
    traffic.check();
    if (with_full_disk) use_full_disk(traffic, actions);
    act(traffic, actions, size_.actions / 2);
    end(traffic, actions, how);
  } catch (const std::exception& e) {
    throw Failure(std::string(e.what()) + "\n" + traffic.text());
  }
  folder_.clear();
}

void Round::check_start(Traffic& traffic) {
  const e2e::Json hello = traffic.call("hello");
  if (inherited_.latched) {
    if (hello["state"] == "armed")
      throw Failure("the ball is armed, though an emergency stop was on the disk: " + hello.dump());
    ++summary_.latches;
  }
  if (inherited_.orderly && hello["reason"] == "state_lost")
    throw Failure("the state is lost, though nothing but the daemon wrote it");
  // A file with the same path and time is the same file.
  const auto left = folder_.incomplete();
  for (const auto& [path, change] : inherited_.incomplete) {
    const auto found = left.find(path);
    if (found != left.end() && found->second == change)
      throw Failure(path + " was left by a kill and is still there");
  }
  inherited_ = {};
}

void Round::act(Traffic& traffic, Actions& actions, int count) {
  constexpr int kBetweenChecks = 300;
  for (int i = 0; i < count; ++i) {
    actions.act();
    if (i % kBetweenChecks == kBetweenChecks - 1) traffic.check();
  }
}

void Round::use_full_disk(Traffic& traffic, Actions& actions) {
  ++summary_.full_disks;
  disk_was_full_ = true;
  folder_.fill();
  act(traffic, actions, size_.actions / 4);
  traffic.check();
  folder_.free();
  // The daemon retries the write within a second.
  traffic.pump_until([&] { return traffic.call("device.emergency_stop").value("on_disk", false); },
                     [] { return std::string("the latch on a disk that has space again"); });
}

void Round::end(Traffic& traffic, Actions& actions, End how) {
  switch (how) {
    case End::kTerminate:
      traffic.check();
      return terminate(traffic, SIGTERM, true);
    case End::kInterrupt:
      traffic.check();
      return terminate(traffic, SIGINT, true);
    case End::kTerminateBusy:
      return terminate(traffic, SIGTERM, false);
    case End::kKill:
      return kill(traffic);
    case End::kKillLatched:
      return stop_and_kill(traffic, actions);
    case End::kKillFull:
      if (folder_.is_small_disk()) {
        folder_.fill();
        disk_was_full_ = true;
      }
      act(traffic, actions, size_.actions / 8);
      kill(traffic);
      folder_.free();
  }
}

void Round::stop_and_kill(Traffic& traffic, Actions& actions) {
  // From here on no request that was sent earlier can arm the ball.
  traffic.check();
  actions.disable_arming();
  act(traffic, actions, size_.actions / 8);
  const e2e::Json stopped = traffic.call("device.emergency_stop");
  act(traffic, actions, static_cast<int>(random_.below(3)));
  kill(traffic);
  inherited_.latched = stopped.value("on_disk", false);
}

void Round::kill(Traffic& traffic) {
  traffic.expect_end();
  daemon_->stop(SIGKILL);
  ++summary_.kills;
  check_log(traffic.log().text());
  inherited_.orderly = !folder_.state().empty() && !folder_.has_planted() && !disk_was_full_;
  if (inherited_.orderly) inherited_.incomplete = folder_.incomplete();
}

void Round::terminate(Traffic& traffic, int signal, bool is_quiet) {
  traffic.expect_end();
  const int code = daemon_->stop(signal);
  ++summary_.stops;
  check_log(traffic.log().text());
  if (code != 0) throw Failure("the exit code is " + std::to_string(code));
  const auto left = folder_.incomplete();
  if (!left.empty() && !folder_.has_planted())
    throw Failure(left.begin()->first + " is left after an orderly end");
  if (is_quiet && !folder_.has_planted()) {
    const e2e::Json state = e2e::Json::parse(folder_.state(), nullptr, false);
    if (!state.is_object() || !state.contains("clean_stop"))
      throw Failure("no state is left after an orderly end: " + folder_.state());
  }
  inherited_.orderly = !folder_.has_planted();
}

}  // namespace hedgehog::soak
