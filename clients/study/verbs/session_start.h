// SPDX-License-Identifier: MIT
// What `run`, `resume` and `rehearse` have in common.
#pragma once

#include <optional>
#include <string>

#include "clients/lib/client_error.h"
#include "clients/study/journal/journal.h"
#include "clients/study/session/runner.h"
#include "clients/study/study_folder.h"
#include "clients/study/verbs/checklist.h"

namespace hedgehog::study {

/// Says it on stderr; the exit code.
int complain(const Problem& problem);
int complain(const client::ClientError& error);

/// Tells the person how the run ended, and the shell.
/// Nothing of what the participant may not know when the run is blind.
int print_end(const Journal& journal, RunEnd end, const std::string& why_stuck);

/// The runs of a participant and experiment.
struct RunsSoFar {
  /// The last that has begun; a kill may leave a file without any event behind.
  std::optional<JournalName> last{};
  bool over = false;  // that one is
  int next = 1;       // the first free number
};
RunsSoFar runs_so_far(const StudyFolder& study, const std::string& participant,
                      const std::string& experiment);
bool is_over(const JournalName& name);

/// As planned. Who is not in the plan may take part too; the seed then comes from the name.
Participant participant_of(const StudyFolder& study, const std::string& id);

/// EX_CONFIG when the ball cannot play all of the experiment.
Result<void> is_played_by(const Player& player, const Experiment& experiment);
/// The same, and EX_CONFIG when it is not the ball on which the run was begun.
Result<void> goes_on_with(const Player& player, const RecordedRun& run);
/// Whether an unfinished run may go on with a daemon, or a start of it, that it was not on: a
/// serial number that is the same is enough, else the experimenter is asked. Where a program
/// answers, the daemon must be at the run's address, or its address have been `given`. EX_CONFIG:
/// it may not.
Result<void> confirm_daemon(const RecordedRun& run, const Pin& now, bool given, const Ask& ask);
/// EX_TEMPFAIL when between two connections another daemon, or another start of it, took over.
Result<void> is_still(const Pin& before, const Pin& now);
/// Writes down that the run goes on, and with which daemon if that is not the one it was on.
Result<void> append_resumed(Journal& journal, const Pin& now);

struct RunKind {
  bool simulated = false;
  bool blind = false;
};
/// A new run's journal.
Result<Journal> begin(const StudyFolder& study, const std::string& participant,
                      const Experiment& experiment, int run, const Pin& pin, RunKind kind);

}  // namespace hedgehog::study
