// SPDX-License-Identifier: MIT
#include "clients/study/rules/trace.h"

namespace hedgehog::study {

Tracer::Tracer(const Experiment& experiment)
    : experiment_(experiment), staircase_(experiment.rule) {}

bool Tracer::take(char token) {
  const bool catch_trial = token == 'Y' || token == 'N';
  const bool scored = token == '0' || token == '1';
  if ((!catch_trial && !scored && token != 'T') ||
      (catch_trial && experiment_.task != Task::kYesNo))
    return false;
  if (staircase_.over()) {
    ++trace_.unused;
    return true;
  }
  trace_.levels.push_back(catch_trial ? 0 : staircase_.level());
  if (scored) {
    trace_.steps.push_back(staircase_.answer(token == '1'));
  } else if (catch_trial) {
    ++trace_.catches;
    trace_.false_alarms += token == 'Y' ? 1 : 0;
  } else {
    ++trace_.voids;
  }
  return true;
}

Trace Tracer::result() const {
  Trace trace = trace_;
  const StaircaseState& state = staircase_.state();
  trace.reversals = state.reversals;
  trace.status = staircase_.status();
  trace.scored = state.scored;
  trace.floor_hits = state.floor_hits;
  trace.ceiling_hits = state.ceiling_hits;
  if (const auto counted = staircase_.counted_reversals(); !counted.empty())
    trace.threshold = mean_decimal(counted, experiment_.decimals());
  return trace;
}

std::variant<Trace, std::string> trace(const Experiment& experiment, std::string_view tokens) {
  Tracer tracer(experiment);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tracer.take(tokens[i])) {
      const bool catch_trial = tokens[i] == 'Y' || tokens[i] == 'N';
      return "response " + std::to_string(i + 1) + ": '" + tokens[i] + "' " +
             (catch_trial ? "is a catch trial, and " + experiment.name + " has none"
                          : "is none of 1, 0, Y, N, T");
    }
  }
  return tracer.result();
}

}  // namespace hedgehog::study
