// SPDX-License-Identifier: MIT
#include "clients/study/report/bids.h"

#include <unistd.h>

#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "clients/common/csv.h"
#include "clients/study/report/rows.h"
#include "clients/study/report/sidecar.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// An error if two different texts have the same label, or a text has an empty label.
std::optional<Problem> check_labels(const std::set<std::string>& texts, const char* prefix) {
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

Result<void> write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.flush();
  if (!out) return Problem{EX_IOERR, file.string() + ": cannot be written"};
  return {};
}

/// Written under a temporary name first, so that a failure leaves no partial output.
Result<void> write_atomically(const fs::path& path,
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

std::string table(const AnalysedRun& run, std::string (*line)(const std::vector<std::string>&),
                  bool heading) {
  std::string text;
  if (heading) {
    std::vector<std::string> names;
    for (const Column& column : columns()) names.emplace_back(column.name);
    text = line(names) + "\n";
  }
  const RunUse use{run.excluded ? std::optional(run.excluded->reason) : std::nullopt, run.in_group};
  for (const auto& row : rows_of(run.run, use)) text += line(row) + "\n";
  return text;
}

/// Descriptions of the columns of participants.tsv.
ordered_json participants_columns() {
  return {{"participant_id", {{"Description", "code of the participant"}}},
          {"hand_size_cm",
           {{"Description", "from the tip of the index finger to the wrist"}, {"Units", "cm"}}},
          {"dominant_hand",
           {{"Description", "hand that rested on the ball"},
            {"Levels", {{"left", "left hand"}, {"right", "right hand"}}}}},
          {"age_band", {{"Description", "years, from-to, or from+"}, {"Units", "years"}}}};
}

std::string participants_table(const std::vector<AnalysedRun>& runs) {
  // The latest check list of each participant.
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

namespace {

/// The text of the README that BIDS requires.
std::string readme(const StudyFolder& study) {
  return study.path().filename().string() +
         ": perception experiments with a Hedgehog ball, recorded by hedgehog-study.\n\n"
         "Each sub-*/beh/*_beh.tsv is one run, a row for each presentation block; its\n"
         "columns, the protocol, the ball and the notes of the session are in the JSON file\n"
         "beside it. Rows with included = 1 moved the staircase of a run that was not\n"
         "excluded; the column excluded says why a run was. The means are those of the runs\n"
         "with in_mean = 1: finished, not excluded, the last one of their participant, and not\n"
         "simulated where people took the experiment with a real ball.\n";
}

/// The experimenters' codes, and the program: the BIDS validator warns about a single author.
std::vector<std::string> experimenters(const std::vector<AnalysedRun>& runs) {
  std::set<std::string> codes;
  for (const AnalysedRun& run : runs)
    if (const auto& list = run.run.checklist(); list && !list->experimenter.empty())
      codes.insert(list->experimenter);
  std::vector<std::string> authors(codes.begin(), codes.end());
  if (authors.empty()) authors.emplace_back("n/a");
  authors.emplace_back("hedgehog-study");
  return authors;
}

Result<void> write_folder(const fs::path& folder, const StudyFolder& study,
                          const std::vector<AnalysedRun>& runs,
                          const std::vector<std::string>& authors) {
  std::error_code failed;
  for (const AnalysedRun& run : runs) {
    const fs::path base = folder / bids_name(run);
    fs::create_directories(base.parent_path(), failed);
    if (auto written = write(base.string() + ".tsv", table(run, tsv_line, true)); !written)
      return written;
    if (auto written = write(base.string() + ".json", bids_sidecar(run)); !written) return written;
  }
  const ordered_json description{
      {"Name", study.path().filename().string()},
      {"BIDSVersion", "1.9.0"},
      {"DatasetType", "raw"},
      {"Authors", authors.empty() ? experimenters(runs) : authors},
      {"GeneratedBy", {{{"Name", "hedgehog-study"}, {"Version", HEDGEHOG_VERSION}}}}};
  fs::create_directories(folder, failed);
  // A folder's name, and an author, may have any bytes.
  const std::string text =
      description.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  if (auto written = write(folder / "dataset_description.json", text); !written) return written;
  if (auto written = write(folder / "README", readme(study)); !written) return written;
  if (auto written = write(folder / "participants.json", participants_columns().dump(2) + "\n");
      !written)
    return written;
  return write(folder / "participants.tsv", participants_table(runs));
}

}  // namespace

Result<void> write_bids(const fs::path& out, const StudyFolder& study,
                        const std::vector<AnalysedRun>& runs,
                        const std::vector<std::string>& authors) {
  // "bids/" is a path without a file name.
  const fs::path folder = out.has_filename() ? out : out.parent_path();
  std::error_code failed;
  if (fs::exists(folder, failed))
    return Problem{EX_CANTCREAT, folder.string() + " is there already; --out names another"};
  std::set<std::string> people;
  std::set<std::string> experiments;
  for (const AnalysedRun& run : runs) {
    people.insert(run.name.participant);
    experiments.insert(run.name.experiment);
  }
  for (const auto& problem : {check_labels(people, "sub-"), check_labels(experiments, "task-")})
    if (problem) return *problem;
  return write_atomically(folder, [&](const fs::path& unfinished) {
    return write_folder(unfinished, study, runs, authors);
  });
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
    text += table(run, client::csv_line, text.empty());
    ordered_json header{{"Participant", run.name.participant}, {"Run", run.name.run}};
    header.update(ordered_json::parse(bids_sidecar(run)));
    headers.push_back(header);
  }
  const auto put = [](const fs::path& path, const std::string& content) {
    return write_atomically(path,
                            [&](const fs::path& unfinished) { return write(unfinished, content); });
  };
  if (auto written = put(beside, headers.dump(2) + "\n"); !written) return written;
  auto written = put(file, text);
  if (!written) fs::remove(beside, failed);
  return written;
}

}  // namespace hedgehog::study
