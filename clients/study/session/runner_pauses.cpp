// SPDX-License-Identifier: MIT
// The runner between two trials: waiting for the ball, the participants and the daemon.
#include <utility>

#include "clients/study/session/runner.h"
#include "clients/study/session/waiting_time.h"

namespace hedgehog::study {

namespace {

using client::Milliseconds;
using std::chrono::steady_clock;

constexpr Milliseconds kStatusPoll{100};
constexpr Milliseconds kReconnect{2000};

}  // namespace

Result<Runner::Early> Runner::until_ready(const Trial& trial) {
  if (!lost_.empty()) {
    auto early = reconnect(std::exchange(lost_, {}));
    if (!early || *early) return early;
  }
  bool waiting = false;
  bool lost_before = false;
  WaitingTime waited(steady_clock::now());
  while (true) {
    if (auto seen = poll_input(Milliseconds{0}); !seen) return seen.error();
    if (stop_requested()) return stop_early();
    if (std::exchange(pause_requested_, false)) {
      auto early = pause(Phase::kPaused, "by the experimenter");
      if (!early || *early) return early;
    }
    const auto ready = player_->readiness(journal_.run().header().experiment, trial);
    const bool refused = !ready && ready.error().failure == client::Failure::kRefused;
    if (!ready && !refused) {
      if (desk_.unattended() && waited.is_over(steady_clock::now()))
        return stuck(ready.error().message);
      if (std::exchange(lost_before, true)) {
        if (auto seen = poll_input(kReconnect); !seen) return seen.error();
      }
      auto early = reconnect(ready.error().message);
      if (!early || *early) return early;
      continue;
    }
    const Readiness now = ready ? *ready : Readiness{false, ready.error().message};
    if (now.ready) {
      if (waiting) {
        if (auto written = journal_.append(Remark{"continued", now.why_not}); !written)
          return written.error();
      }
      show(Phase::kReady, 0, now.why_not);
      return Early{};
    }
    if (!std::exchange(waiting, true)) {
      if (auto written = journal_.append(Remark{"paused", now.why_not}); !written)
        return written.error();
    }
    show(Phase::kPaused, 0, now.why_not);
    // The request of this trial stays invalid, however long it waits.
    const bool is_permanent = refused && ready.error().refusal &&
                              ready.error().refusal->code == protocol::ErrorCode::kInvalidParams;
    const auto clock = steady_clock::now();
    const bool waited_enough = now.cooling_at_ns ? waited.is_over_cooling(clock, *now.cooling_at_ns)
                                                 : waited.is_over(clock);
    if (desk_.unattended() && (is_permanent || waited_enough)) return stuck(now.why_not);
    if (auto seen = poll_input(kStatusPoll); !seen) return seen.error();
    if (auto kept = player_->keep(Milliseconds{0}); !kept) lost_ = kept.error().message;
  }
}

Result<Runner::Early> Runner::rest() {
  const RecordedRun& run = journal_.run();
  const int every = run.header().experiment.rest_every;
  const int scored = run.state().staircase().state().scored;
  if (every == 0 || scored == 0 || scored % every != 0 || desk_.unattended() ||
      run.trials().empty() || run.trials().back().trial.kind != TrialKind::kScored ||
      !run.trials().back().void_reason.empty())
    return Early{};
  return pause(Phase::kRest, "time for a rest");
}

Result<Runner::Early> Runner::pause(Phase phase, const std::string& why) {
  if (auto written = journal_.append(Remark{phase == Phase::kRest ? "rest" : "paused", why});
      !written)
    return written.error();
  continue_requested_ = false;
  while (!continue_requested_) {
    show(phase, 0, why + "; c continues", true);
    if (auto seen = poll_input(kStatusPoll); !seen) return seen.error();
    if (stop_requested()) return stop_early();
    if (lost_.empty()) {
      if (auto kept = player_->keep(Milliseconds{0}); !kept) lost_ = kept.error().message;
    }
  }
  pause_requested_ = false;
  if (auto written = journal_.append(Remark{"continued", ""}); !written) return written.error();
  return lost_.empty() ? Result<Early>(Early{}) : reconnect(std::exchange(lost_, {}));
}

Result<Runner::Early> Runner::reconnect(const std::string& why) {
  if (auto written = journal_.append(Remark{"paused", why}); !written) return written.error();
  player_.reset();
  const WaitingTime waited(steady_clock::now());
  std::string waiting = why + "; waiting for the ball";
  while (true) {
    show(Phase::kPaused, 0, waiting);
    auto again = Player::open({address_}, kReconnect);
    const Identity identity =
        again ? compare(journal_.run().pin(), again->pin()) : Identity::kOther;
    if (again && identity != Identity::kOther) {
      player_ = *std::move(again);
      lost_.clear();
      if (identity == Identity::kSame) break;
      auto early = accept_start();
      if (!early || *early) return early;
      if (lost_.empty()) break;
      waiting = std::exchange(lost_, {}) + "; waiting for the ball";
      player_.reset();
    } else if (again) {
      waiting = "another ball is there: " + again->ball().name;
    }
    if (auto seen = poll_input(kStatusPoll); !seen) return seen.error();
    if (stop_requested()) return stop_early();
    if (desk_.unattended() && waited.is_over(steady_clock::now())) return stuck(why);
  }
  if (auto written = journal_.append(Remark{"continued", kBallReturned}); !written)
    return written.error();
  return Early{};
}

Result<Runner::Early> Runner::accept_start() {
  continue_requested_ = desk_.unattended();
  while (!continue_requested_) {
    show(Phase::kPaused, 0,
         "the daemon was restarted: is it the same ball? c goes on with it, q stops", true);
    if (auto seen = poll_input(kStatusPoll); !seen) return seen.error();
    if (stop_requested()) return stop_early();
    if (auto kept = player_->keep(Milliseconds{0}); !kept) {
      lost_ = kept.error().message;
      return Early{};
    }
  }
  if (auto written = journal_.append(DaemonChanged{player_->pin().daemon}); !written)
    return written.error();
  return Early{};
}

Result<void> Runner::poll_input(std::chrono::milliseconds timeout) {
  return handle_input(desk_.wait(timeout));
}

Result<void> Runner::handle_input(const Input& input) {
  switch (input.kind) {
    case Input::Kind::kPause:
      pause_requested_ = true;
      break;
    case Input::Kind::kContinue:
      continue_requested_ = true;
      break;
    case Input::Kind::kVoid:
      void_requested_ = true;
      break;
    case Input::Kind::kStop:
      stop_requested_ = true;
      break;
    case Input::Kind::kNote:
      return journal_.append(Remark{"note", input.text});
    case Input::Kind::kAnswer:  // outside of a question
    case Input::Kind::kNone:
      break;
  }
  return {};
}

Result<void> Runner::record_note() {
  const auto note = desk_.unfinished_note();
  return note && !note->empty() ? journal_.append(Remark{"note", *note}) : Result<void>();
}

Result<Runner::Early> Runner::stop_early() {
  if (auto kept = record_note(); !kept) return kept.error();
  if (journal_.run().open()) {
    if (auto written = journal_.append(Voided{"stopped"}); !written) return written.error();
  }
  if (auto written = journal_.append(Remark{"stopped", ""}); !written) return written.error();
  return Early{RunEnd::kStopped};
}

}  // namespace hedgehog::study
