// SPDX-License-Identifier: MIT
#pragma once

#include "clients/study/rules/observer.h"
#include "clients/study/rules/run.h"

namespace hedgehog::study {

/// A complete run of a simulated observer, as replayed from a journal.
inline RunState answered(const Experiment& e, const Observer& o, std::uint64_t seed) {
  RunState run(e, {seed, seed}, false);
  while (const auto trial = run.next()) {
    const double level = to_value(trial->level, e.decimals());
    const bool positive = draw(seed, Purpose::kAnswer,
                               {static_cast<std::uint64_t>(trial->number),
                                static_cast<std::uint64_t>(trial->kind)}) < o.positive_at(level);
    if (e.task == Task::kYesNo)
      run.answer(positive ? Answer::kYes : Answer::kNo);
    else
      run.answer((trial->interval_of_test == 1) == positive ? Answer::kFirst : Answer::kSecond);
  }
  return run;
}

}  // namespace hedgehog::study
