// SPDX-License-Identifier: MIT
// Comparison of the connected ball and daemon with those of a run.
#pragma once

#include "clients/study/journal/event.h"

namespace hedgehog::study {

enum class Identity : std::uint8_t {
  kSame,      // the same start of the same daemon, or the same ball of a daemon without start id
  kUnproven,  // possibly the same: neither contradicted nor proven
  kOther,     // another ball
};

/// The ball and daemon to which a run is bound.
struct Pin {
  BallFacts ball{};
  DaemonFacts daemon{};
};

/// A start of the daemon is identified by its id. If one side has none, the ball's serial number at
/// the same address is compared (at any address if the journal has none); balls without a serial
/// number, such as all simulated ones, are then never the same. A new calibration does not change
/// the identity of a ball.
Identity compare(const Pin& then, const Pin& now);
/// True for the same ball by its serial number, independent of the daemon.
bool same_serial(const BallFacts& a, const BallFacts& b);

}  // namespace hedgehog::study
