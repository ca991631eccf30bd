// SPDX-License-Identifier: MIT
#include <cstdio>

#include "clients/common/interrupts.h"
#include "clients/common/terminal.h"
#include "clients/study/session/simulated_desk.h"
#include "clients/study/verbs/run_verb.h"
#include "clients/study/verbs/session_start.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

namespace {

// Long enough for a restart of the daemon.
constexpr client::Milliseconds kRehearsalTimeout{60'000};
constexpr int kBarWidth = 30;

/// Study and daemon of a rehearsal.
struct Start {
  const StudyFolder& study;
  const std::vector<client::Address>& addresses;
  bool address_given = false;
};

/// Starts or resumes one run of a rehearsal. 0: it is over.
int rehearse_one(const Start& start, const Participant& participant, const Experiment& experiment,
                 const std::function<void(const View&)>& report) {
  const RunHistory runs = run_history(start.study, participant.id, experiment.name);
  if (runs.over) return 0;
  auto player = Player::open(start.addresses, kRehearsalTimeout);
  if (!player) return report_error(player.error());
  if (const auto plays = check_playable(*player, experiment); !plays)
    return report_error(plays.error());
  auto journal = runs.last ? Journal::open(runs.last->path)
                           : begin(start.study, participant.id, experiment, runs.next,
                                   player->pin(), {.simulated = true});
  if (!journal) return report_error(journal.error());
  const RunStarted& header = journal->run().header();
  if (!header.simulated_person) {
    return study::report_error(EX_DATAERR, journal->path().string() +
                                               " is of a person; rehearse in "
                                               "a study of its own");
  }
  if (const auto same = check_same_ball(*player, journal->run()); !same)
    return report_error(same.error());
  if (const auto meant =
          confirm_daemon(journal->run(), player->pin(), start.address_given, prompt_terminal);
      !meant)
    return report_error(meant.error());
  if (runs.last) {
    if (auto written = append_resumed(*journal, player->pin()); !written)
      return report_error(written.error());
  }
  SimulatedDesk desk(simulated_person(header.experiment, header.person_seed), header.person_seed,
                     report);
  Runner runner(*journal, *std::move(player), desk, client::interrupted);
  const auto end = runner.run();
  if (!end) return report_error(end.error());
  return *end == RunEnd::kOver ? 0 : print_end(*journal, *end, runner.stuck_reason());
}

}  // namespace

int run_rehearse(const RunOptions& options) {
  client::watch_interrupts();
  const auto study = StudyFolder::find(".");
  if (!study) return report_error(study.error());
  const auto addresses = client::daemon_addresses(options.address);
  if (!addresses) return report_error(addresses.error());
  const Start start{*study, *addresses, options.address.has_value()};
  const std::size_t all = study->plan().participants.size() * study->plan().experiments.size();
  std::size_t done = 0;
  const bool bar = client::is_terminal();
  for (const Participant& participant : study->plan().participants) {
    for (const std::string& name : participant.order) {
      const auto experiment = study->experiment(name);
      if (!experiment) return report_error(experiment.error());
      if (const auto checked = study->is_unmistakable(*experiment); !checked)
        return report_error(checked.error());
      const auto report = [&](const View& view) {
        if (!bar || view.phase != Phase::kReady) return;
        const double part =
            static_cast<double>(view.run->state().staircase().state().reversals.size()) /
            experiment->rule.total_reversals();
        const double share = (static_cast<double>(done) + part) / static_cast<double>(all);
        std::string filled;
        for (int i = 0; i < kBarWidth; ++i) filled += i < share * kBarWidth ? "█" : "░";
        std::printf("\r%s %2zu of %zu runs  %s %s, trial %d\033[K", filled.c_str(), done, all,
                    participant.id.c_str(), name.c_str(),
                    view.run->state().staircase().state().scored + 1);
        std::fflush(stdout);
      };
      if (const int code = rehearse_one(start, participant, *experiment, report); code != 0)
        return code;
      ++done;
      if (!bar) {
        std::printf("%2zu of %zu  %s %s\n", done, all, participant.id.c_str(), name.c_str());
        std::fflush(stdout);
      }
    }
  }
  std::printf("%s%zu runs of %zu participants are complete\n", bar ? "\r\033[K" : "", done,
              study->plan().participants.size());
  return 0;
}

}  // namespace hedgehog::study
