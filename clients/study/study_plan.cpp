// SPDX-License-Identifier: MIT
#include "clients/study/study_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/parse_json.h"
#include "clients/study/journal/journal.h"

namespace hedgehog::study {

namespace {

using nlohmann::ordered_json;

/// A seed that every JSON parser represents exactly.
std::uint64_t drawn_seed(std::uint64_t seed, std::initializer_list<std::uint64_t> words) {
  return draw_bits(seed, Purpose::kSeed, words) >> 11;
}

std::string participant_id(int number) { return fmt::format("P{:02}", number); }

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
    if (static_cast<int>(first.size()) < count) first.push_back(count - step);
  }
  std::vector<std::vector<int>> rows;
  for (int row = 0; row < count; ++row) {
    std::vector<int> shifted;
    shifted.reserve(first.size());
    for (const int place : first) shifted.push_back((place + row) % count);
    rows.push_back(shifted);
  }
  // For an odd number one square cannot balance the successors; with its mirror image it does.
  if (count % 2 == 1 && count > 1) {
    for (int row = 0; row < count; ++row) {
      const std::vector<int> straight = rows[static_cast<std::size_t>(row)];
      rows.emplace_back(straight.rbegin(), straight.rend());
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
    for (const int place : square[static_cast<std::size_t>(i) % square.size()])
      p.order.push_back(plan.experiments[static_cast<std::size_t>(place)]);
    plan.participants.push_back(p);
  }
  return plan;
}

std::string bids_label(const std::string& name) {
  std::string label;
  std::copy_if(name.begin(), name.end(), std::back_inserter(label),
               [](unsigned char c) { return std::isalnum(c) != 0; });
  return label;
}

RunSeeds run_seeds(const Participant& participant, const std::string& experiment, int run) {
  const auto number = static_cast<std::uint64_t>(run);
  return {drawn_seed(participant.seed, {word_of(experiment), number, word_of("order")}),
          drawn_seed(participant.seed, {word_of(experiment), number, word_of("catches")})};
}

std::string plan_text(const StudyPlan& plan) {
  ordered_json participants = ordered_json::array();
  for (const Participant& p : plan.participants)
    participants.push_back({{"id", p.id}, {"order", p.order}, {"seed", p.seed}});
  const ordered_json file{{"seed", plan.seed},
                          {"experiments", plan.experiments},
                          {"created", plan.created},
                          {"software_version", plan.software_version},
                          {"participants", participants}};
  return file.dump(2) + "\n";
}

Result<StudyPlan> parse_plan(std::string_view text) {
  const auto parsed = base::parse_json<ordered_json>(text, base::JsonComments::kAllowed);
  if (!parsed.good()) return Problem{EX_DATAERR, parsed.problem};
  try {
    const ordered_json& json = parsed.value;
    StudyPlan plan;
    plan.seed = json.at("seed");
    plan.experiments = json.at("experiments").get<std::vector<std::string>>();
    plan.created = json.at("created");
    plan.software_version = json.at("software_version");
    for (const ordered_json& p : json.at("participants"))
      plan.participants.push_back({p.at("id"), p.at("order"), p.at("seed")});
    return plan;
  } catch (const std::exception& error) {
    return Problem{EX_DATAERR, error.what()};
  }
}

}  // namespace hedgehog::study
