// SPDX-License-Identifier: MIT
// Whether what answers now is what a run was on.
#pragma once

#include "clients/study/journal/event.h"

namespace hedgehog::study {

enum class Identity : std::uint8_t {
  kSame,      // the same start of the same daemon, or of a daemon that tells no start the same ball
  kUnproven,  // perhaps: nothing contradicts it, and nothing shows it
  kOther,     // another ball
};

/// What a run is pinned to.
struct Pin {
  BallFacts ball{};
  DaemonFacts daemon{};
};

/// A start of the daemon is told by its id. Where one side has none, the ball's serial number at
/// the same address counts (at any, where the journal has none); balls without a serial number,
/// as all simulated ones, are never the same by that. A calibration that was measured again makes
/// no other ball.
Identity compare(const Pin& then, const Pin& now);
/// The same ball by its serial number, whatever daemon drives it.
bool same_serial(const BallFacts& a, const BallFacts& b);

}  // namespace hedgehog::study
