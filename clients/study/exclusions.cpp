// SPDX-License-Identifier: MIT
#include "clients/study/exclusions.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/parse_json.h"
#include "base/regular_file.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t kMaxExclusionsBytes = std::size_t{1} << 20;
constexpr const char* kExclusionsFile = "exclusions.json";

bool is_of(const Exclusion& exclusion, const JournalName& name) {
  return exclusion.participant == name.participant && exclusion.experiment == name.experiment &&
         exclusion.run == name.run;
}

}  // namespace

Result<Exclusions> Exclusions::read(const StudyFolder& study) {
  Exclusions exclusions(study.path() / "journal" / kExclusionsFile);
  const fs::path& file = exclusions.file_;
  const base::FileText text = base::read_regular_file(file.string(), kMaxExclusionsBytes);
  if (text.missing) return exclusions;
  const auto wrong = [&](const std::string& what) {
    return Problem{EX_DATAERR, file.string() + ": " + what};
  };
  if (!text.good()) return wrong(text.problem);
  const auto parsed = base::parse_json<ordered_json>(text.text);
  if (!parsed.good()) return wrong(parsed.problem);
  try {
    for (const ordered_json& one : parsed.value.at("excluded")) {
      exclusions.all_.push_back({one.at("participant"), one.at("experiment"), one.at("run"),
                                 one.at("reason"), one.at("time")});
    }
  } catch (const std::exception& error) {
    return wrong(error.what());
  }
  return exclusions;
}

const Exclusion* Exclusions::of(const JournalName& name) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const Exclusion& one) { return is_of(one, name); });
  return found == all_.end() ? nullptr : &*found;
}

void Exclusions::add(const Exclusion& exclusion) {
  remove({exclusion.participant, exclusion.experiment, exclusion.run, {}});
  all_.push_back(exclusion);
}

bool Exclusions::remove(const JournalName& name) {
  return std::erase_if(
             all_, [&](const Exclusion& one) { return is_of(one, name); }) > 0;
}

Result<void> Exclusions::write() const {
  ordered_json all = ordered_json::array();
  for (const Exclusion& one : all_) {
    all.push_back({{"participant", one.participant},
                   {"experiment", one.experiment},
                   {"run", one.run},
                   {"reason", one.reason},
                   {"time", one.time}});
  }
  constexpr mode_t kForEverybody = 0644;
  // Text typed by the user may not be UTF-8.
  const std::string text =
      ordered_json{{"excluded", all}}.dump(2, ' ', false, ordered_json::error_handler_t::replace);
  const std::string problem =
      base::write_file_atomically(file_.string(), text + "\n", kForEverybody);
  if (!problem.empty()) return Problem{EX_IOERR, problem};
  return {};
}

}  // namespace hedgehog::study
