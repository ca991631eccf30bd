// SPDX-License-Identifier: MIT
// For tests on a busy machine that delays the test, a program or the ball: leases in the ball's
// time continue to run, and a ball with threads of its own is lost after 100 ms.
#pragma once

#include <sys/wait.h>

#include <chrono>
#include <functional>
#include <string>

#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {

/// Waits until the ball is armed. It arms itself at the start; after a loss this arms it.
inline bool arms(RawClient& owner) {
  return eventually([&] {
    const Json status = owner.call("device.status");
    const bool was_lost = status["reason"] == "hot_plug" || status["reason"] == "board_dead_man";
    if (was_lost) owner.call("device.arm");
    return status["state"] == "armed";
  });
}

/// Starts the hold, or renews the one it started, for ten seconds; returns its admission or the
/// error.
inline Json renew_hold(RawClient& client, Json params) {
  params["slot"] = "kept";
  params["lease_ms"] = 10'000;
  const Json renewed = client.call("effect.update", {{"slot", "kept"}});
  return renewed.contains("effect") ? renewed : client.call("effect.hold", params);
}

/// True if the process has ended. `wait` still returns its end.
inline bool has_ended(const Program& program) {
  siginfo_t end{};
  const auto pid = static_cast<id_t>(program.pid());
  return ::waitid(P_PID, pid, &end, WEXITED | WNOHANG | WNOWAIT) != 0 || end.si_pid != 0;
}

/// Waits for the end of `program`; calls `renew` at once and every second until then.
inline Ended wait_renewing(Program& program, const std::function<void()>& renew) {
  constexpr std::chrono::seconds kRenewal{1};
  for (auto waited = kRenewal; waited <= kLongTimeout; waited += kRenewal) {
    renew();
    if (wait_until([&] { return has_ended(program); }, kRenewal)) break;
  }
  return program.wait();
}

/// Repeats `play` while it ends because the lease of its effect expired. hedgehogctl renews a lease
/// of 1 s twenty times a second, which a busy machine may delay.
inline Ended play_unexpired(const std::function<Ended()>& play) {
  Ended ended;
  eventually([&] {
    ended = play();
    return ended.out.find("expired") == std::string::npos;
  });
  return ended;
}

/// Waits until `screen` shows `text`; calls `renew` until then.
inline bool shows_renewing(TerminalProgram& screen, const std::string& text,
                           const std::function<void()>& renew) {
  return eventually([&] {
    renew();
    screen.shows("");  // reads the output
    return screen.shown().find(text) != std::string::npos;
  });
}

/// Types `keys` repeatedly until `done`. Reads the output meanwhile: a full terminal would block
/// the program.
inline bool type_until(TerminalProgram& screen, const std::string& keys,
                       const std::function<bool()>& done) {
  return eventually([&] {
    screen.type(keys);
    screen.shows("");
    return done();
  });
}

}  // namespace hedgehog::e2e
