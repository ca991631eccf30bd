// SPDX-License-Identifier: MIT
#include "clients/study/study_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <regex>
#include <system_error>

#include "base/atomic_file.h"
#include "clients/study/experiment_file.h"
#include "clients/study/journal/journal.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "study.json";

Result<StudyPlan> read_plan(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  auto plan = parse_plan(std::string{std::istreambuf_iterator<char>(in), {}});
  if (!plan) return Problem{EX_DATAERR, file.string() + ": " + plan.error().message};
  return plan;
}

Result<void> write_whole(const fs::path& file, const std::string& text) {
  constexpr mode_t kForEverybody = 0644;
  const std::string problem = base::write_file_atomically(file.string(), text, kForEverybody);
  if (!problem.empty()) return Problem{EX_IOERR, problem};
  std::error_code failed;
  base::sync_folder(fs::absolute(file, failed).parent_path().parent_path().string());
  return {};
}

/// Copies an experiment's file to experiments/NAME.json.
Result<void> adopt(const fs::path& study, const fs::path& file) {
  const auto experiment = find_experiment(file.string());
  if (!experiment) return experiment.error();
  const fs::path own = study / "experiments" / (experiment->name + ".json");
  std::error_code failed;
  if (fs::exists(own, failed)) {  // left by a plan that was killed
    const auto there = find_experiment(own.string());
    return there && *there == *experiment
               ? Result<void>()
               : Problem{EX_CANTCREAT, own.string() + " is there already"};
  }
  fs::create_directories(own.parent_path(), failed);
  std::ifstream in(file, std::ios::binary);
  return write_whole(own, {std::istreambuf_iterator<char>(in), {}});
}

}  // namespace

Result<StudyFolder> StudyFolder::create(const fs::path& path, const StudyPlan& plan,
                                        const std::vector<fs::path>& experiments) {
  std::error_code failed;
  const fs::path file = path / kFile;
  if (fs::exists(file, failed)) return Problem{EX_CANTCREAT, file.string() + " is there already"};
  fs::create_directories(path / "journal", failed);
  for (const fs::path& experiment : experiments)
    if (auto adopted = adopt(path, experiment); !adopted) return adopted.error();
  if (auto written = write_whole(file, plan_text(plan)); !written) return written.error();
  StudyFolder folder;
  folder.path_ = path;
  folder.plan_ = plan;
  return folder;
}

Result<StudyFolder> StudyFolder::find(const fs::path& from) {
  std::error_code failed;
  const fs::path start = fs::weakly_canonical(fs::absolute(from, failed), failed);
  for (fs::path folder = start;; folder = folder.parent_path()) {
    if (fs::exists(folder / kFile, failed)) {
      auto plan = read_plan(folder / kFile);
      if (!plan) return plan.error();
      StudyFolder study;
      study.path_ = folder;
      study.plan_ = *std::move(plan);
      return study;
    }
    if (folder == folder.root_path() || folder.empty()) {
      return Problem{EX_NOINPUT, "no study.json in " + start.string() +
                                     " or above; make a study with hedgehog-study plan NAME"};
    }
  }
}

fs::path StudyFolder::journal_path(const std::string& participant, const std::string& experiment,
                                   int run) const {
  return path_ / "journal" /
         (participant + "." + experiment + "." + std::to_string(run) + ".jsonl");
}

Result<Experiment> StudyFolder::experiment(const std::string& name_or_file) const {
  const fs::path own = path_ / "experiments" / (name_or_file + ".json");
  std::error_code failed;
  const bool is_name = name_or_file.find('/') == std::string::npos;
  return find_experiment(is_name && fs::exists(own, failed) ? own.string() : name_or_file);
}

Result<void> StudyFolder::is_unmistakable(const Experiment& experiment) const {
  if (auto checked = is_no_other_preset(experiment); !checked) return checked;
  for (const JournalName& name : journals()) {
    if (name.experiment != experiment.name) continue;
    // Unreadable journals are reported when they are read.
    const auto lines = read_journal(name.path);
    const auto* header =
        lines && !lines->empty() ? std::get_if<RunStarted>(&lines->front().event) : nullptr;
    if (header != nullptr && header->experiment != experiment) {
      return Problem{EX_CONFIG, experiment.name + " is not the one of " + name.path.string() +
                                    ": give it a name of its own"};
    }
  }
  return {};
}

Result<void> StudyFolder::is_unmistakable(const std::string& participant) const {
  const std::string label = bids_label(participant);
  if (label.empty()) return Problem{EX_USAGE, participant + " has neither a letter nor a digit"};
  const auto check = [&](const std::string& other) -> Result<void> {
    if (other != participant && bids_label(other) == label)
      return Problem{EX_USAGE, participant + " would be taken for " + other +
                                   " in an export to BIDS: take another name"};
    return {};
  };
  for (const Participant& planned : plan_.participants)
    if (auto checked = check(planned.id); !checked) return checked;
  for (const JournalName& name : journals())
    if (auto checked = check(name.participant); !checked) return checked;
  return {};
}

std::vector<JournalName> StudyFolder::journals() const {
  static const std::regex kName("([A-Za-z0-9_-]+)\\.([a-z0-9-]+)\\.([0-9]{1,6})\\.jsonl");
  std::vector<JournalName> found;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path_ / "journal", failed)) {
    std::smatch parts;
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, parts, kName))
      found.push_back({parts[1], parts[2], std::stoi(parts[3]), entry.path()});
  }
  std::sort(found.begin(), found.end(), [](const JournalName& a, const JournalName& b) {
    return std::tie(a.participant, a.experiment, a.run) <
           std::tie(b.participant, b.experiment, b.run);
  });
  return found;
}

}  // namespace hedgehog::study
