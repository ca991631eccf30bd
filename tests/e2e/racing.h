// SPDX-License-Identifier: MIT
// The racing game's ball on a real daemon.
#pragma once

#include <chrono>
#include <vector>

#include "clients/racer/feel/feel.h"
#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"

namespace hedgehog::e2e {

inline std::vector<client::Address> addresses_of(const DaemonProcess& daemon) {
  return {client::parse_address(daemon.socket()).value()};
}

/// A number of frames, and their duration if each waited for the daemon up to its timeout of 1 s.
inline constexpr int kRaceFrames = 1000;
inline constexpr auto kBlockingDuration = kRaceFrames * std::chrono::seconds(1);

/// Waits until the daemon responds and its ball is armed: the game sends no effects before.
inline bool connects(racer::Feel& feel, double time_s = 0.0) {
  return eventually([&] {
    feel.frame({}, time_s);
    return feel.ball().connected && feel.ball().state == "armed";
  });
}

}  // namespace hedgehog::e2e
