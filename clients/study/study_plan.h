// SPDX-License-Identifier: MIT
// Participants of a study, their orders of experiments, and random seeds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/rules/run.h"

namespace hedgehog::study {

/// The largest integer that every JSON parser represents exactly.
constexpr std::uint64_t kMaxSeed = (std::uint64_t{1} << 53) - 1;

struct Participant {
  std::string id{};
  std::vector<std::string> order{};  // names of experiments
  std::uint64_t seed = 0;            // below 2^53, as the study's own
};

struct StudyPlan {
  std::uint64_t seed = 0;
  std::vector<std::string> experiments{};
  std::vector<Participant> participants{};
  std::string created{};
  std::string software_version{};

  const Participant* participant(const std::string& id) const noexcept;
};

/// The orders of `count` conditions in which each is at each position, and after each other one,
/// equally often (Williams 1949): `count` rows for an even count, twice as many for an odd one.
std::vector<std::vector<int>> latin_square(int count);

/// P01, P02, ...; the order by the participant's row in the square, the seeds derived from `seed`.
StudyPlan make_plan(int participants, std::vector<std::string> experiments, std::uint64_t seed);

/// The random streams of one run, from the participant's seed.
RunSeeds run_seeds(const Participant& participant, const std::string& experiment, int run);

/// The letters and digits of a name, which BIDS allows.
std::string bids_label(const std::string& name);

/// Writes and parses study.json. EX_DATAERR with the error.
std::string plan_text(const StudyPlan& plan);
Result<StudyPlan> parse_plan(std::string_view text);

}  // namespace hedgehog::study
