// SPDX-License-Identifier: MIT
#include "clients/study/verbs/trace_verb.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "clients/study/experiment_file.h"
#include "clients/study/rules/trace.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

ordered_json decimals(const std::vector<Level>& levels, int places) {
  ordered_json list = ordered_json::array();
  for (const Level level : levels) list.push_back(exact_decimal(level, places));
  return list;
}

void print_json(const Experiment& experiment, const Trace& trace) {
  const int places = experiment.decimals();
  const ordered_json result{
      {"experiment", experiment.name},
      {"unit", experiment.unit()},
      {"levels", decimals(trace.levels, places)},
      {"reversal_levels", decimals(trace.reversals, places)},
      {"threshold", trace.threshold ? ordered_json(*trace.threshold) : ordered_json(nullptr)},
      {"status", name(trace.status)},
      {"n_scored", trace.scored},
      {"n_catch", trace.catches},
      {"false_alarms", trace.false_alarms},
      {"n_void", trace.voids},
      {"floor_hits", trace.floor_hits},
      {"ceil_hits", trace.ceiling_hits},
      {"unused_tokens", trace.unused}};
  std::puts(result.dump().c_str());
}

void print_table(const Experiment& experiment, const std::string& responses, const Trace& trace) {
  const int places = experiment.decimals();
  std::printf("  trial  answer  level (%s)\n", experiment.unit());
  std::size_t step = 0;
  for (std::size_t i = 0; i < trace.levels.size(); ++i) {
    const bool scored = responses[i] == '0' || responses[i] == '1';
    const Step* done = scored ? &trace.steps[step++] : nullptr;
    std::string note = done != nullptr && done->reversal > 0
                           ? "reversal " + std::to_string(done->reversal)
                           : std::string();
    if (!scored) note = responses[i] == 'T' ? "void" : "catch trial";
    std::printf("  %5zu  %6c  %10s  %s\n", i + 1, responses[i],
                exact_decimal(trace.levels[i], places).c_str(), note.c_str());
  }
  std::printf("%s, %d scored trials, %zu reversals, threshold %s\n",
              std::string(name(trace.status)).c_str(), trace.scored, trace.reversals.size(),
              trace.threshold ? (*trace.threshold + " " + experiment.unit()).c_str() : "none");
}

}  // namespace

int report_error(int exit_code, const std::string& message) {
  std::fprintf(stderr, "hedgehog-study: %s\n", message.c_str());
  return exit_code;
}

int run_trace(const TraceOptions& options) {
  const auto experiment = find_experiment(options.experiment);
  if (!experiment) return report_error(experiment.error().exit_code, experiment.error().message);
  const auto traced = trace(*experiment, options.responses);
  if (const auto* mistake = std::get_if<std::string>(&traced))
    return report_error(EX_DATAERR, *mistake);
  const Trace& result = std::get<Trace>(traced);
  if (options.json)
    print_json(*experiment, result);
  else
    print_table(*experiment, options.responses, result);
  return 0;
}

}  // namespace hedgehog::study
