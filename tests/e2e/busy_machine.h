// SPDX-License-Identifier: MIT
// What a test does against a machine that holds up the test, a program or the ball: leases of the
// ball's time go on meanwhile, and a ball with threads of its own is lost after 100 ms.
#pragma once

#include <sys/wait.h>

#include <chrono>
#include <functional>
#include <string>

#include "tests/e2e/patience.h"
#include "tests/e2e/program.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::e2e {

/// Waits until the ball is armed. It arms itself at the start; one that was lost is armed here.
inline bool arms(RawClient& owner) {
  return eventually([&] {
    const Json status = owner.call("device.status");
    const bool was_lost = status["reason"] == "hot_plug" || status["reason"] == "board_dead_man";
    if (was_lost) owner.call("device.arm");
    return status["state"] == "armed";
  });
}

/// Renews the hold that it has started, or starts it, for ten seconds; its admission, or the error.
inline Json keep_holding(RawClient& client, Json params) {
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
  for (auto waited = kRenewal; waited <= kLongPatience; waited += kRenewal) {
    renew();
    if (wait_until([&] { return has_ended(program); }, kRenewal)) break;
  }
  return program.wait();
}

/// Calls `play` again as long as the lease of its effect ran out. hedgehogctl renews one of a
/// second twenty times a second, which a busy machine may hold up.
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
    screen.shows("");  // reads what was drawn
    return screen.shown().find(text) != std::string::npos;
  });
}

/// Types `keys` again and again until `done`. Reads what is drawn meanwhile: a full terminal would
/// hold the program up.
inline bool type_until(TerminalProgram& screen, const std::string& keys,
                       const std::function<bool()>& done) {
  return eventually([&] {
    screen.type(keys);
    screen.shows("");
    return done();
  });
}

}  // namespace hedgehog::e2e
