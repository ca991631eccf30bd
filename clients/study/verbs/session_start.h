// SPDX-License-Identifier: MIT
// What `run`, `resume` and `rehearse` have in common.
#pragma once

#include <optional>
#include <string>

#include "clients/lib/client_error.h"
#include "clients/study/journal/journal.h"
#include "clients/study/session/runner.h"
#include "clients/study/study_folder.h"

namespace hedgehog::study {

/// True from the first SIGINT, SIGTERM or SIGHUP after `watch_interrupts`.
bool interrupted();
void watch_interrupts();

/// Says it on stderr; the exit code.
int complain(const Problem& problem);
int complain(const client::ClientError& error);

/// Tells the person how the run ended, and the shell.
/// `blind`: nothing of what the participant may not know.
int say_end(const Journal& journal, RunEnd end, bool blind = false);

/// The runs of a participant and experiment.
struct RunsSoFar {
  /// The last that has begun; a kill may leave a file without any event behind.
  std::optional<JournalName> last{};
  bool over = false;  // that one is
  int next = 1;       // the first free number
};
RunsSoFar runs_so_far(const StudyFolder& study, const std::string& participant,
                      const std::string& experiment);
bool has_begun(const JournalName& name);
bool is_over(const JournalName& name);

/// As planned. Who is not in the plan may take part too; the seed then comes from the name.
Participant participant_of(const StudyFolder& study, const std::string& id);

/// A new run's journal.
Result<Journal> begin(const StudyFolder& study, const std::string& participant,
                      const Experiment& experiment, int run, const BallFacts& ball, bool simulated);

/// Where a run takes place.
struct Start {
  const StudyFolder& study;
  const std::vector<client::Address>& addresses;
  bool blind = false;
};

}  // namespace hedgehog::study
