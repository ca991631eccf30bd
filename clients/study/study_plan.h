// SPDX-License-Identifier: MIT
// Who takes part in a study, in which order, with which random seeds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clients/common/problem.h"
#include "clients/study/rules/run.h"

namespace hedgehog::study {

/// The largest seed that any JSON reader keeps.
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

/// The orders of `count` conditions in which each stands in each place, and behind each other one,
/// equally often (Williams 1949): count rows for an even count, twice as many for an odd one.
std::vector<std::vector<int>> latin_square(int count);

/// P01, P02, ...; the order by the participant's place in the square, the seeds from `seed`.
StudyPlan make_plan(int participants, std::vector<std::string> experiments, std::uint64_t seed);

/// The streams of one run, from the participant's seed.
RunSeeds run_seeds(const Participant& participant, const std::string& experiment, int run);

/// What BIDS leaves of a name: its letters and digits.
std::string bids_label(const std::string& name);

/// study.json, and back. EX_DATAERR naming what is wrong.
std::string plan_text(const StudyPlan& plan);
Result<StudyPlan> parse_plan(std::string_view text);

}  // namespace hedgehog::study
