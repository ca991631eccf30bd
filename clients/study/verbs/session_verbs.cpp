// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

#include "clients/common/interrupts.h"
#include "clients/common/terminal.h"
#include "clients/study/journal/journal.h"
#include "clients/study/session/runner.h"
#include "clients/study/session/simulated_desk.h"
#include "clients/study/session/terminal_desk.h"
#include "clients/study/study_folder.h"
#include "clients/study/verbs/checklist.h"
#include "clients/study/verbs/run_verb.h"
#include "clients/study/verbs/session_start.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

namespace fs = std::filesystem;

constexpr client::Milliseconds kConnectTimeout{2000};
// Time to read a message before the screen is cleared.
constexpr std::chrono::seconds kReading{3};
constexpr const char* kPage = "participant.sock";

int execute_run(const StudyFolder& study, Journal& journal, Player player) {
  const RunStarted& header = journal.run().header();
  Result<RunEnd> end = RunEnd::kStopped;
  std::string stuck_reason;
  const auto run_at = [&](Desk& desk) {
    Runner runner(journal, std::move(player), desk, client::interrupted);
    end = runner.run();
    stuck_reason = runner.stuck_reason();
  };
  if (header.simulated_person) {
    SimulatedDesk desk(simulated_person(header.experiment, header.person_seed), header.person_seed,
                       [](const View&) {});
    run_at(desk);
  } else {
    auto page = ParticipantServer::listen(study.path() / kPage);
    if (!page) {
      std::fprintf(stderr, "hedgehog-study: the participant's page is not available: %s\n",
                   page.error().message.c_str());
      std::this_thread::sleep_for(kReading);
    }
    TerminalDesk desk(page ? std::optional(*std::move(page)) : std::nullopt, journal.run().blind());
    run_at(desk);
  }
  if (!end) return report_error(end.error());
  return print_end(journal, *end, stuck_reason);
}

void print_resumed(const Journal& journal) {
  if (journal.run().blind()) {
    std::puts("going on");
    std::fflush(stdout);
    return;
  }
  const RecordedRun& run = journal.run();
  const Staircase& staircase = run.state().staircase();
  std::printf("%s %s: %d trials kept%s; going on at %s %s.\n", run.header().participant.c_str(),
              run.header().experiment.name.c_str(), staircase.state().scored,
              run.open()
                  ? (", trial " + std::to_string(run.open()->trial.number) + " is void").c_str()
                  : "",
              exact_decimal(staircase.level(), run.header().experiment.decimals()).c_str(),
              run.header().experiment.unit());
  std::fflush(stdout);
}

}  // namespace

int run_run(const RunOptions& options) {
  client::watch_interrupts();
  const auto study = StudyFolder::find(".");
  if (!study) return report_error(study.error());
  const auto experiment = study->experiment(options.experiment);
  if (!experiment) return report_error(experiment.error());
  for (const auto& checked :
       {study->is_unmistakable(*experiment), study->is_unmistakable(options.participant)})
    if (!checked) return report_error(checked.error());
  const RunHistory runs = run_history(*study, options.participant, experiment->name);
  if (runs.last && !runs.over && !options.again) {
    if (const auto readable = read_run(runs.last->path); !readable)
      return report_error(readable.error());
    return study::report_error(EX_TEMPFAIL,
                               runs.last->path.string() +
                                   " is not finished: hedgehog-study resume goes on with "
                                   "it, --again begins another");
  }
  if (runs.over && !options.again) {
    return study::report_error(EX_CANTCREAT, options.participant + " has done " + experiment->name +
                                                 "; --again makes another run");
  }
  if (!options.simulated && !client::is_terminal())
    return study::report_error(EX_USAGE, "a person needs a terminal; --simulated does not");
  const auto addresses = client::daemon_addresses(options.address);
  if (!addresses) return report_error(addresses.error());
  auto wanted = *addresses;
  std::optional<Pin> seen;
  std::optional<Checklist> checklist;
  if (!options.simulated) {
    // Checked before any question; the claim would expire during the questions.
    const auto there = Player::open(*addresses, kConnectTimeout);
    if (!there) return report_error(there.error());
    if (const auto plays = check_playable(*there, *experiment); !plays)
      return report_error(plays.error());
    wanted = {there->address()};
    seen = there->pin();
    checklist = complete(options.checklist);
    if (!checklist)
      return study::report_error(EX_TEMPFAIL, "not everything is ready; nothing was begun");
  }
  auto player = Player::open(wanted, kConnectTimeout);
  if (!player) return report_error(player.error());
  if (const auto still = check_same_start(seen.value_or(player->pin()), player->pin()); !still)
    return report_error(still.error());
  if (const auto plays = check_playable(*player, *experiment); !plays)
    return report_error(plays.error());
  auto journal = begin(*study, options.participant, *experiment, runs.next, player->pin(),
                       {options.simulated, options.blind});
  if (!journal) return report_error(journal.error());
  if (checklist) {
    if (auto written = journal->append(*checklist); !written) return report_error(written.error());
  }
  return execute_run(*study, *journal, *std::move(player));
}

int run_resume(const RunOptions& options) {
  client::watch_interrupts();
  const auto study = StudyFolder::find(".");
  if (!study) return report_error(study.error());
  std::optional<JournalName> chosen;
  for (const JournalName& name : study->journals()) {
    const bool wanted = (options.participant.empty() || name.participant == options.participant) &&
                        (options.experiment.empty() || name.experiment == options.experiment);
    std::error_code failed;
    if (wanted && has_begun(name.path) && !is_over(name) &&
        (!chosen ||
         fs::last_write_time(name.path, failed) > fs::last_write_time(chosen->path, failed)))
      chosen = name;
  }
  if (!chosen) return study::report_error(EX_NOINPUT, "no run is unfinished");
  auto journal = Journal::open(chosen->path);
  if (!journal) return report_error(journal.error());
  if (!journal->run().header().simulated_person && !client::is_terminal())
    return study::report_error(EX_USAGE, "a person needs a terminal");
  const auto addresses = client::daemon_addresses(options.address);
  if (!addresses) return report_error(addresses.error());
  auto where = *addresses;
  std::optional<Pin> seen;
  std::optional<Checklist> checklist;
  if (!journal->run().header().simulated_person) {
    {
      const auto there = Player::open(*addresses, kConnectTimeout);
      if (!there) return report_error(there.error());
      if (const auto same = check_same_ball(*there, journal->run()); !same)
        return report_error(same.error());
      where = {there->address()};
      seen = there->pin();
    }
    if (const auto meant = confirm_daemon(journal->run(), *seen, false, prompt_terminal); !meant)
      return report_error(meant.error());
    // The participant may have moved since; a run killed early may not have recorded its check
    // list.
    const auto& known = journal->run().checklist();
    checklist = known ? ticked_again(*known) : complete({});
    if (!checklist)
      return study::report_error(EX_TEMPFAIL, "not everything is ready; the run stays as it is");
  }
  auto player = Player::open(where, kConnectTimeout);
  if (!player) return report_error(player.error());
  if (const auto same = check_same_ball(*player, journal->run()); !same)
    return report_error(same.error());
  const auto meant = seen ? check_same_start(*seen, player->pin())
                          : confirm_daemon(journal->run(), player->pin(),
                                           options.address.has_value(), prompt_terminal);
  if (!meant) return report_error(meant.error());
  if (options.blind && !journal->run().blind()) {
    if (auto written = journal->append(Remark{"blind", ""}); !written)
      return report_error(written.error());
  }
  print_resumed(*journal);
  if (auto written = append_resumed(*journal, player->pin()); !written)
    return report_error(written.error());
  if (checklist) {
    if (auto written = journal->append(*checklist); !written) return report_error(written.error());
  }
  return execute_run(*study, *journal, *std::move(player));
}

int run_participant() {
  client::watch_interrupts();
  const auto study = StudyFolder::find(".");
  if (!study) return report_error(study.error());
  if (!client::is_terminal())
    return study::report_error(EX_USAGE, "the participant's page needs a terminal");
  const auto ended = run_participant_page(study->path() / kPage, client::interrupted);
  return ended ? 0 : report_error(ended.error());
}

}  // namespace hedgehog::study
