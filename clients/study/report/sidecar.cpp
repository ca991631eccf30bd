// SPDX-License-Identifier: MIT
#include "clients/study/report/sidecar.h"

#include <sys/utsname.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "clients/study/experiment_file.h"
#include "clients/study/report/rows.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

/// Details that the thesis does not specify, and their implementation here.
ordered_json choices(const Experiment& e) {
  const StaircaseRule& rule = e.rule;
  const bool yes_no = e.task == Task::kYesNo;
  const std::string discarded = std::to_string(rule.discard);
  return {
      {"answers_for_a_step", rule.quick_start
                                 ? "one of each until the first reversal, then " +
                                       std::to_string(rule.positives_down) + " down, " +
                                       std::to_string(rule.negatives_up) + " up"
                                 : std::to_string(rule.positives_down) + " down, " +
                                       std::to_string(rule.negatives_up) + " up from the start"},
      {"initial_step_down", "step_down of the first stage"},
      {"first_reversal_counts",
       rule.discard == 0 ? "for the end and the mean" : "for the end, not for the mean"},
      {"first_answer_negative", "level up, no reversal"},
      {"reversal_level", "at which the turning answer was given"},
      {"step_size_leaving_a_reversal", "already the new one"},
      {"run_counter", "zeroed by every level change and every negative"},
      {"at_the_limits", "level clamped; moves there still turn the direction"},
      {"catch_trials", e.catch_one_in == 0
                           ? "none"
                           : "one in " + std::to_string(e.catch_one_in) +
                                 ", never first, never two in a row; device off; they move "
                                 "nothing"},
      {"zero_level", yes_no ? "scored like any other" : "scored; the random label decides"},
      {"interval_order", yes_no ? "one interval only"
                         : e.order == IntervalOrder::kRandom
                             ? "an independent fair coin a trial"
                             : "the second of each pair the opposite of the first, but for voids"},
      {"void_trials", yes_no ? "nothing scored, same level again"
                             : "nothing scored, same level again, new interval order"},
      {"response_limit", e.response_limit_ms == 0
                             ? "none"
                             : std::to_string(e.response_limit_ms) + " ms, void after that"},
      {"step_unit", yes_no ? "A" : "percentage points of the reference"},
      {"threshold", "arithmetic mean of nominal levels of all reversals but the first " +
                        discarded + "; none if not finished"},
      {"end", "at once with reversal " + std::to_string(rule.total_reversals()) +
                  "; given up after " + std::to_string(rule.max_trials) + " scored trials"},
      {"feedback", "none"}};
}

template <class T>
ordered_json or_missing(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json("n/a");
}

ordered_json or_missing(const std::string& text) {
  return text.empty() ? ordered_json("n/a") : ordered_json(text);
}

std::string operating_system() {
  utsname names{};
  return uname(&names) == 0 ? std::string(names.sysname) + " " + names.release : "n/a";
}

}  // namespace

std::string bids_sidecar(const AnalysedRun& analysed) {
  const RunStarted& header = analysed.run.header();
  const Checklist list = analysed.run.checklist().value_or(Checklist{});
  ordered_json remarks = ordered_json::array();
  for (const Line& line : analysed.run.remarks()) {
    const Remark& remark = std::get<Remark>(line.event);
    remarks.push_back({{"time", line.time}, {"kind", remark.kind}, {"text", remark.text}});
  }
  ordered_json file{{"TaskName", header.experiment.name},
                    {"TaskDescription", header.experiment.question},
                    {"StimulusPresentation",
                     {{"OperatingSystem", operating_system()},
                      {"SoftwareName", "hedgehog-study"},
                      {"SoftwareVersion", header.software_version}}},
                    {"Excluded", analysed.excluded ? ordered_json(analysed.excluded->reason)
                                                   : ordered_json("n/a")},
                    {"InMean", analysed.in_group},
                    {"Started", analysed.run.started()},
                    {"Status", name(analysed.analysis.status)},
                    {"Threshold", or_missing(analysed.analysis.threshold_text)},
                    {"ThresholdUnit", header.experiment.unit()},
                    {"Protocol", ordered_json::parse(experiment_text(header.experiment))},
                    {"Choices", choices(header.experiment)},
                    {"Seeds", {{"order", header.seeds.order}, {"catches", header.seeds.catches}}},
                    {"SimulatedPerson", header.simulated_person},
                    {"Device",
                     {{"name", header.ball.name},
                      {"model", header.ball.model},
                      {"serial", or_missing(header.ball.serial)},
                      {"simulated", header.ball.simulated},
                      {"force_n_per_a", header.ball.force_n_per_a}}},
                    {"HandSizeCm", or_missing(list.hand_size_cm)},
                    {"DominantHand", or_missing(list.dominant_hand)},
                    {"AgeBand", or_missing(list.age_band)},
                    {"ConsentReference", or_missing(list.consent)},
                    {"Experimenter", or_missing(list.experimenter)},
                    {"HeadphoneCheck", list.headphones},
                    {"HandOnTopCheck", list.hand_on_top},
                    {"Remarks", remarks}};
  for (const Column& column : columns()) file[column.name] = {{"Description", column.description}};
  return file.dump(2) + "\n";
}

}  // namespace hedgehog::study
