// SPDX-License-Identifier: MIT
#include "clients/study/verbs/session_start.h"

#include <cstdio>

#include "clients/common/interrupts.h"
#include "clients/study/verbs/trace_verb.h"

namespace hedgehog::study {

int report_error(const Problem& problem) {
  return study::report_error(problem.exit_code, problem.message);
}

int report_error(const client::ClientError& error) {
  int code = EX_UNAVAILABLE;
  if (error.failure == client::Failure::kBadAddress) {
    code = EX_USAGE;
  } else if (error.refusal) {
    switch (error.refusal->code) {
      case protocol::ErrorCode::kClaimed:
        code = EX_TEMPFAIL;
        break;
      case protocol::ErrorCode::kForbidden:
      case protocol::ErrorCode::kUnauthorized:
        code = EX_NOPERM;
        break;
      default:
        break;
    }
  }
  return study::report_error(code, error.message);
}

int print_end(const Journal& journal, RunEnd end, const std::string& stuck_reason) {
  const RecordedRun& run = journal.run();
  const bool blind = run.blind();
  const Experiment& experiment = run.header().experiment;
  const Staircase& staircase = run.state().staircase();
  const auto counted = staircase.counted_reversals();
  if (end == RunEnd::kStuck)
    return study::report_error(EX_TEMPFAIL, stuck_reason + "; hedgehog-study resume goes on");
  if (end == RunEnd::kStopped) {
    if (blind) {
      std::puts("stopped; hedgehog-study resume goes on");
    } else {
      std::printf("stopped after %d scored trials; hedgehog-study resume goes on\n",
                  staircase.state().scored);
    }
    return client::interrupted() ? kInterrupted : EX_TEMPFAIL;
  }
  if (blind) {
    std::puts("done");
  } else if (counted.empty()) {
    std::printf("given up after %d scored trials: no threshold\n", staircase.state().scored);
  } else {
    const double value = mean_value(counted, experiment.decimals());
    std::printf("done: %.4g %s", value, experiment.unit());
    if (experiment.quantity == Quantity::kCurrentA)
      std::printf(" (%.3f N)", value * run.header().ball.force_n_per_a);
    std::printf(", %zu reversals, %d trials\n", staircase.state().reversals.size(),
                staircase.state().scored);
  }
  std::printf("%s\n", journal.path().c_str());
  return 0;
}

Result<void> check_playable(const Player& player, const Experiment& experiment) {
  if (const auto too_much = player.too_much(experiment)) return Problem{EX_CONFIG, *too_much};
  return {};
}

Result<void> check_same_ball(const Player& player, const RecordedRun& run) {
  if (compare(run.pin(), player.pin()) == Identity::kOther) {
    const auto which = [](const BallFacts& ball) {
      return "\"" + ball.name + "\" (" + ball.model +
             (ball.serial ? ", serial " + *ball.serial : "") +
             (ball.simulated ? ", simulated)" : ")");
    };
    return Problem{EX_CONFIG, "the run was begun on " + which(run.header().ball) + " and this is " +
                                  which(player.ball()) +
                                  ": a run cannot change its ball; run --again starts a new run"};
  }
  return check_playable(player, run.header().experiment);
}

Result<void> confirm_daemon(const RecordedRun& run, const Pin& now, bool given, const Prompt& ask) {
  const Pin& then = run.pin();
  if (compare(then, now) == Identity::kSame || same_serial(then.ball, now.ball)) return {};
  const bool same_address =
      then.daemon.address.empty() || then.daemon.address == now.daemon.address;
  const std::string from =
      same_address ? "" : "the run was on the daemon at " + then.daemon.address + ", this is ";
  if (run.header().simulated_person) {
    if (same_address || given) return {};
    return Problem{EX_CONFIG, from + now.daemon.address + ": confirm it with --address"};
  }
  const auto confirmed =
      confirm((same_address ? "the daemon was restarted, or is a different one"
                            : from + now.daemon.address) +
                  "; is \"" + now.ball.name + "\" the ball that the run was begun on?",
              ask);
  if (confirmed.value_or(false)) return {};
  return Problem{EX_CONFIG, "a run cannot change its ball; run --again starts a new run"};
}

Result<void> check_same_start(const Pin& before, const Pin& now) {
  if (before.daemon == now.daemon && compare(before, now) != Identity::kOther) return {};
  return Problem{EX_TEMPFAIL, "the daemon at " + now.daemon.address +
                                  " was restarted in the meantime; start again"};
}

Result<void> append_resumed(Journal& journal, const Pin& now) {
  if (auto written = journal.append(Remark{"resumed", now.ball.name}); !written) return written;
  return journal.run().pin().daemon == now.daemon ? Result<void>()
                                                  : journal.append(DaemonChanged{now.daemon});
}

RunHistory run_history(const StudyFolder& study, const std::string& participant,
                       const std::string& experiment) {
  RunHistory runs;
  for (const JournalName& name : study.journals()) {
    if (name.participant == participant && name.experiment == experiment) {
      runs.next = name.run + 1;
      if (has_begun(name.path)) runs.last = name;
    }
  }
  runs.over = runs.last && is_over(*runs.last);
  return runs;
}

Participant participant_of(const StudyFolder& study, const std::string& id) {
  if (const Participant* planned = study.plan().participant(id)) return *planned;
  return {id, study.plan().experiments,
          draw_bits(study.plan().seed, Purpose::kSeed, {word_of(id)}) >> 11};
}

Result<Journal> begin(const StudyFolder& study, const std::string& participant,
                      const Experiment& experiment, int run, const Pin& pin, RunKind kind) {
  RunStarted header;
  header.participant = participant;
  header.experiment = experiment;
  header.run = run;
  const Participant person = participant_of(study, participant);
  header.seeds = run_seeds(person, experiment.name, run);
  header.person_seed = kind.simulated ? person.seed : 0;
  header.ball = pin.ball;
  header.daemon = pin.daemon;
  header.simulated_person = kind.simulated;
  header.blind = kind.blind;
  header.software_version = HEDGEHOG_VERSION;
  return Journal::create(study.journal_path(participant, experiment.name, run), header);
}

bool is_over(const JournalName& name) {
  const auto run = read_run(name.path);
  return run && run->over();
}

}  // namespace hedgehog::study
