// SPDX-License-Identifier: MIT
#include "clients/study/report/bids.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "clients/common/csv.h"
#include "clients/study/experiment_file.h"
#include "clients/study/report/rows.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The first two texts, or none, that are different and have one label, or a text that has none.
std::optional<Problem> mistakable(const std::set<std::string>& texts, const char* prefix) {
  std::map<std::string, std::string> labelled;
  for (const std::string& text : texts) {
    const auto [place, is_new] = labelled.emplace(bids_label(text), text);
    if (!is_new || place->first.empty()) {
      return Problem{EX_DATAERR, place->second + (is_new ? "" : " and " + text) + " would be " +
                                     prefix + place->first +
                                     " in BIDS, which knows letters and digits only; "
                                     "--format csv keeps the names"};
    }
  }
  return std::nullopt;
}

/// What the thesis leaves open, and how it was done here.
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

Result<void> write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.flush();
  if (!out) return Problem{EX_IOERR, file.string() + ": cannot be written"};
  return {};
}

/// Made under another name first, so that a failure leaves no half of it.
Result<void> in_one_go(const fs::path& path,
                       const std::function<Result<void>(const fs::path&)>& make) {
  const fs::path unfinished = path.string() + "." + std::to_string(::getpid()) + ".part";
  std::error_code failed;
  auto made = make(unfinished);
  if (made) {
    fs::rename(unfinished, path, failed);
    if (!failed) return made;
    made = Problem{EX_CANTCREAT, path.string() + ": " + failed.message()};
  }
  fs::remove_all(unfinished, failed);
  return made;
}

std::string table(const RecordedRun& run, std::string (*line)(const std::vector<std::string>&),
                  bool heading) {
  std::string text;
  if (heading) {
    std::vector<std::string> names;
    for (const Column& column : columns()) names.emplace_back(column.name);
    text = line(names) + "\n";
  }
  for (const auto& row : rows_of(run)) text += line(row) + "\n";
  return text;
}

std::string participants_table(const std::vector<AnalysedRun>& runs) {
  // The latest check list of each.
  std::map<std::string, Checklist> people;
  for (const AnalysedRun& run : runs)
    people[run.name.participant] = run.run.checklist().value_or(people[run.name.participant]);
  std::string text = "participant_id\thand_size_cm\tdominant_hand\tage_band\n";
  for (const auto& [id, list] : people) {
    const auto known = [](const std::string& given) { return given.empty() ? "n/a" : given; };
    text += tsv_line({"sub-" + bids_label(id),
                      list.hand_size_cm ? ordered_json(*list.hand_size_cm).dump() : "n/a",
                      known(list.dominant_hand), known(list.age_band)}) +
            "\n";
  }
  return text;
}

}  // namespace

std::string bids_name(const AnalysedRun& run) {
  const std::string subject = "sub-" + bids_label(run.name.participant);
  return subject + "/beh/" + subject + "_task-" + bids_label(run.name.experiment) + "_run-" +
         std::to_string(run.name.run) + "_beh";
}

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
                    {"SoftwareName", "hedgehog-study"},
                    {"SoftwareVersion", header.software_version},
                    {"OperatingSystem", operating_system()},
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

namespace {

Result<void> write_folder(const fs::path& folder, const StudyFolder& study,
                          const std::vector<AnalysedRun>& runs) {
  std::error_code failed;
  for (const AnalysedRun& run : runs) {
    const fs::path base = folder / bids_name(run);
    fs::create_directories(base.parent_path(), failed);
    if (auto written = write(base.string() + ".tsv", table(run.run, tsv_line, true)); !written)
      return written;
    if (auto written = write(base.string() + ".json", bids_sidecar(run)); !written) return written;
  }
  const ordered_json description{
      {"Name", study.path().filename().string()},
      {"BIDSVersion", "1.9.0"},
      {"DatasetType", "raw"},
      {"GeneratedBy", {{{"Name", "hedgehog-study"}, {"Version", HEDGEHOG_VERSION}}}}};
  fs::create_directories(folder, failed);
  if (auto written = write(folder / "dataset_description.json", description.dump(2) + "\n");
      !written)
    return written;
  return write(folder / "participants.tsv", participants_table(runs));
}

}  // namespace

Result<void> write_bids(const fs::path& folder, const StudyFolder& study,
                        const std::vector<AnalysedRun>& runs) {
  std::error_code failed;
  if (fs::exists(folder, failed))
    return Problem{EX_CANTCREAT, folder.string() + " is there already; --out names another"};
  std::set<std::string> people;
  std::set<std::string> experiments;
  for (const AnalysedRun& run : runs) {
    people.insert(run.name.participant);
    experiments.insert(run.name.experiment);
  }
  for (const auto& mistaken : {mistakable(people, "sub-"), mistakable(experiments, "task-")})
    if (mistaken) return *mistaken;
  return in_one_go(
      folder, [&](const fs::path& unfinished) { return write_folder(unfinished, study, runs); });
}

Result<void> write_csv(const fs::path& file, const std::vector<AnalysedRun>& runs) {
  std::error_code failed;
  if (fs::exists(file, failed))
    return Problem{EX_CANTCREAT, file.string() + " is there already; --out names another"};
  const fs::path beside = file.string() + ".json";
  if (fs::exists(beside, failed))
    return Problem{EX_CANTCREAT, beside.string() + " is there already; --out names another"};
  std::string text;
  ordered_json headers = ordered_json::array();
  for (const AnalysedRun& run : runs) {
    text += table(run.run, client::csv_line, text.empty());
    ordered_json header{{"Participant", run.name.participant}, {"Run", run.name.run}};
    header.update(ordered_json::parse(bids_sidecar(run)));
    headers.push_back(header);
  }
  const auto put = [](const fs::path& path, const std::string& content) {
    return in_one_go(path, [&](const fs::path& unfinished) { return write(unfinished, content); });
  };
  if (auto written = put(beside, headers.dump(2) + "\n"); !written) return written;
  auto written = put(file, text);
  if (!written) fs::remove(beside, failed);
  return written;
}

}  // namespace hedgehog::study
