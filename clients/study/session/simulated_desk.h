// SPDX-License-Identifier: MIT
// A person who is a program: answers by a psychometric curve, at once.
#pragma once

#include <functional>

#include "clients/study/rules/observer.h"
#include "clients/study/session/desk.h"

namespace hedgehog::study {

/// An answer depends on the person, the experiment and the trial, never on how often it had to be
/// repeated: kills and voids change no threshold.
class SimulatedDesk : public Desk {
 public:
  /// `report` sees every view (for a progress bar).
  SimulatedDesk(const Observer& observer, std::uint64_t seed,
                std::function<void(const View&)> report);

  void show(const View& view) override;
  Input wait(std::chrono::milliseconds patience) override;
  bool unattended() const override { return true; }

 private:
  Observer observer_;
  std::uint64_t seed_;
  std::function<void(const View&)> report_;
  View view_{};
};

/// Whom the simulated participant `seed` is in this experiment.
Observer simulated_person(const Experiment& experiment, std::uint64_t seed);

}  // namespace hedgehog::study
