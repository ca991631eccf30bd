// SPDX-License-Identifier: MIT
// Shared parts of `run`, `resume` and `rehearse`.
#pragma once

#include <optional>
#include <string>

#include "clients/lib/client_error.h"
#include "clients/study/journal/journal.h"
#include "clients/study/session/runner.h"
#include "clients/study/study_folder.h"
#include "clients/study/verbs/checklist.h"

namespace hedgehog::study {

/// Prints the error to stderr; returns the exit code.
int report_error(const Problem& problem);
int report_error(const client::ClientError& error);

/// Prints how the run ended and returns the exit code. Prints no results if the run is blind.
int print_end(const Journal& journal, RunEnd end, const std::string& stuck_reason);

/// The runs of a participant and experiment.
struct RunHistory {
  /// The last that has begun; a kill may leave a journal without events.
  std::optional<JournalName> last{};
  bool over = false;  // of that run
  int next = 1;       // the first free number
};
RunHistory run_history(const StudyFolder& study, const std::string& participant,
                       const std::string& experiment);
bool is_over(const JournalName& name);

/// As planned. Participants that are not in the plan are allowed; their seed is derived from the
/// id.
Participant participant_of(const StudyFolder& study, const std::string& id);

/// EX_CONFIG if the ball cannot play all of the experiment.
Result<void> check_playable(const Player& player, const Experiment& experiment);
/// The same, and EX_CONFIG if it is not the ball on which the run was begun.
Result<void> check_same_ball(const Player& player, const RecordedRun& run);
/// Whether an unfinished run may continue with another daemon, or another start of it: the same
/// serial number is sufficient, otherwise the experimenter is asked. For a simulated run the daemon
/// must be at the run's address, or its address must be `given`. EX_CONFIG: not allowed.
Result<void> confirm_daemon(const RecordedRun& run, const Pin& now, bool given, const Prompt& ask);
/// EX_TEMPFAIL if another daemon, or another start of it, replaced the first between two
/// connections.
Result<void> check_same_start(const Pin& before, const Pin& now);
/// Records that the run continues, and with which daemon if it has changed.
Result<void> append_resumed(Journal& journal, const Pin& now);

struct RunKind {
  bool simulated = false;
  bool blind = false;
};
/// Creates the journal of a new run.
Result<Journal> begin(const StudyFolder& study, const std::string& participant,
                      const Experiment& experiment, int run, const Pin& pin, RunKind kind);

}  // namespace hedgehog::study
