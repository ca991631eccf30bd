// SPDX-License-Identifier: MIT
#include "clients/study/study_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <system_error>

#include "clients/study/experiment_file.h"
#include "clients/study/journal/journal.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kFile = "study.json";

/// A seed that every JSON reader keeps.
std::uint64_t drawn_seed(std::uint64_t seed, std::initializer_list<std::uint64_t> words) {
  return draw_bits(seed, Purpose::kSeed, words) >> 11;
}

std::string participant_id(int number) {
  char id[16];
  std::snprintf(id, sizeof id, "P%02d", number);
  return id;
}

std::string text_of(const StudyPlan& plan) {
  ordered_json participants = ordered_json::array();
  for (const Participant& p : plan.participants) {
    participants.push_back({{"id", p.id}, {"order", p.order}, {"seed", p.seed}});
  }
  const ordered_json file{{"seed", plan.seed},
                          {"experiments", plan.experiments},
                          {"created", plan.created},
                          {"software_version", plan.software_version},
                          {"participants", participants}};
  return file.dump(2) + "\n";
}

Result<StudyPlan> read_plan(const fs::path& file) {
  std::ifstream in(file);
  try {
    const ordered_json json = ordered_json::parse(in, nullptr, true, true);
    StudyPlan plan;
    plan.seed = json.at("seed");
    plan.experiments = json.at("experiments").get<std::vector<std::string>>();
    plan.created = json.at("created");
    plan.software_version = json.at("software_version");
    for (const ordered_json& p : json.at("participants")) {
      plan.participants.push_back({p.at("id"), p.at("order"), p.at("seed")});
    }
    return plan;
  } catch (const std::exception& error) {
    return Problem{EX_DATAERR, file.string() + ": " + error.what()};
  }
}

}  // namespace

const Participant* StudyPlan::participant(const std::string& id) const noexcept {
  const auto found = std::find_if(participants.begin(), participants.end(),
                                  [&](const Participant& p) { return p.id == id; });
  return found == participants.end() ? nullptr : &*found;
}

std::vector<std::vector<int>> latin_square(int count) {
  // 0, 1, n-1, 2, n-2, ...: neighbours differ by each distance once.
  std::vector<int> first{0};
  for (int step = 1; static_cast<int>(first.size()) < count; ++step) {
    first.push_back(step);
    if (static_cast<int>(first.size()) < count) {
      first.push_back(count - step);
    }
  }
  std::vector<std::vector<int>> rows;
  for (int row = 0; row < count; ++row) {
    std::vector<int> shifted;
    shifted.reserve(first.size());
    for (const int place : first) {
      shifted.push_back((place + row) % count);
    }
    rows.push_back(shifted);
    if (count % 2 == 1 && count > 1) {
      rows.emplace_back(shifted.rbegin(), shifted.rend());
    }
  }
  return rows;
}

StudyPlan make_plan(int participants, std::vector<std::string> experiments, std::uint64_t seed) {
  StudyPlan plan;
  plan.seed = seed;
  plan.experiments = std::move(experiments);
  plan.created = utc_now();
  plan.software_version = HEDGEHOG_VERSION;
  const auto square = latin_square(static_cast<int>(plan.experiments.size()));
  for (int i = 0; i < participants; ++i) {
    Participant p;
    p.id = participant_id(i + 1);
    p.seed = drawn_seed(seed, {static_cast<std::uint64_t>(i)});
    for (const int place : square[static_cast<std::size_t>(i) % square.size()]) {
      p.order.push_back(plan.experiments[static_cast<std::size_t>(place)]);
    }
    plan.participants.push_back(p);
  }
  return plan;
}

RunSeeds run_seeds(const Participant& participant, const std::string& experiment, int run) {
  const auto number = static_cast<std::uint64_t>(run);
  return {drawn_seed(participant.seed, {word_of(experiment), number, word_of("order")}),
          drawn_seed(participant.seed, {word_of(experiment), number, word_of("catches")})};
}

Result<StudyFolder> StudyFolder::create(const fs::path& path, const StudyPlan& plan) {
  std::error_code failed;
  fs::create_directories(path / "journal", failed);
  const fs::path file = path / kFile;
  const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (out < 0) {
    return Problem{EX_CANTCREAT, file.string() + ": " +
                                     std::error_code(errno, std::generic_category()).message()};
  }
  const std::string text = text_of(plan);
  const bool written = ::write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const bool kept = ::fsync(out) == 0;
  ::close(out);
  if (!written || !kept) {
    return Problem{EX_IOERR, file.string() + ": cannot be written"};
  }
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
      if (!plan) {
        return plan.error();
      }
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
  if (auto checked = is_no_other_preset(experiment); !checked) {
    return checked;
  }
  for (const JournalName& name : journals()) {
    if (name.experiment != experiment.name) {
      continue;
    }
    // What cannot be read says so where it is read.
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

Result<void> StudyFolder::adopt(const Experiment& experiment, const fs::path& file) const {
  const fs::path own = path_ / "experiments" / (experiment.name + ".json");
  std::error_code failed;
  fs::create_directories(own.parent_path(), failed);
  fs::copy_file(file, own, failed);
  if (failed) {
    return Problem{EX_CANTCREAT, own.string() + ": " + failed.message()};
  }
  return {};
}

std::vector<JournalName> StudyFolder::journals() const {
  static const std::regex kName("([A-Za-z0-9_-]+)\\.([a-z0-9-]+)\\.([0-9]{1,6})\\.jsonl");
  std::vector<JournalName> found;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(path_ / "journal", failed)) {
    std::smatch parts;
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, parts, kName)) {
      found.push_back({parts[1], parts[2], std::stoi(parts[3]), entry.path()});
    }
  }
  std::sort(found.begin(), found.end(), [](const JournalName& a, const JournalName& b) {
    return std::tie(a.participant, a.experiment, a.run) <
           std::tie(b.participant, b.experiment, b.run);
  });
  return found;
}

}  // namespace hedgehog::study
