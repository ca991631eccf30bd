// SPDX-License-Identifier: MIT
// A short run as recorded in a journal.
#pragma once

#include <string>
#include <vector>

#include "clients/study/experiment_file.h"
#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

inline IntervalPlayed good(int interval, double current_a) {
  const std::int64_t onset = 1'000'000'000LL * (1 + 6 * interval);
  return {interval,
          {current_a, 10},
          onset - 500'000'000,
          onset - 499'000'000,
          onset,
          onset + 5'000'000'000,
          "completed",
          1.0,
          1.0,
          0,
          0,
          current_a,
          30.0,
          model::Quaternion{0.5, 0.5, 0.5, -0.5}};
}

/// A practice trial, a right answer, a void trial, a wrong answer.
inline RecordedRun recorded() {
  RunStarted header;
  header.participant = "P01";
  header.experiment = find_experiment("force-jnd").value();
  header.experiment.practice = 1;
  header.seeds = {7, 8};
  header.software_version = "0.1.0";
  std::vector<Line> lines{{1, "t", header}};
  const auto put = [&](const Event& event) {
    lines.push_back({static_cast<std::int64_t>(lines.size()) + 1, "t", event});
  };
  for (const char* what : {"right", "right", "void", "wrong"}) {
    const Trial trial = *RecordedRun::replay(lines).value().state().next();
    const bool first = trial.interval_of_test == 1;
    put(TrialStarted{trial});
    put(good(1, first ? 10 : 5));
    put(good(2, first ? 5 : 10));
    if (std::string(what) == "void") {
      put(Voided{"a comma, and a \"quote\""});
    } else {
      put(Answered{first == (std::string(what) == "right") ? Answer::kFirst : Answer::kSecond,
                   640});
    }
  }
  return RecordedRun::replay(lines).value();
}

}  // namespace hedgehog::study
