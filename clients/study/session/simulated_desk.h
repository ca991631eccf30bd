// SPDX-License-Identifier: MIT
// A simulated participant: responds by a psychometric curve, at once.
#pragma once

#include <functional>

#include "clients/study/rules/observer.h"
#include "clients/study/session/desk.h"

namespace hedgehog::study {

/// A response depends on the person, the experiment and the trial, not on its repetitions: kills
/// and voids do not change the threshold.
class SimulatedDesk : public Desk {
 public:
  /// `report` is called with every view (for a progress bar).
  SimulatedDesk(const Observer& observer, std::uint64_t seed,
                std::function<void(const View&)> report);

  void show(const View& view) override;
  Input wait(std::chrono::milliseconds timeout) override;
  bool unattended() const override { return true; }

 private:
  Observer observer_;
  std::uint64_t seed_;
  std::function<void(const View&)> report_;
  View view_{};
};

/// The observer of the simulated participant `seed` in this experiment.
Observer simulated_person(const Experiment& experiment, std::uint64_t seed);

}  // namespace hedgehog::study
