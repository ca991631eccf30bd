// SPDX-License-Identifier: MIT
#include "clients/study/session/runner.h"

#include <utility>

namespace hedgehog::study {

namespace {

using client::Milliseconds;
using std::chrono::steady_clock;

constexpr Milliseconds kDeskPoll{10};
constexpr int kTooManyVoids = 5;
constexpr int kTooManyTimeouts = 50;
constexpr const char* kTimeout = "no answer in time";

}  // namespace

Runner::Runner(Journal& journal, Player player, Desk& desk, std::function<bool()> stop)
    : journal_(journal),
      player_(std::move(player)),
      address_(player_->address()),
      desk_(desk),
      stop_(std::move(stop)) {}

void Runner::show(Phase phase, int interval, const std::string& message, bool waits) {
  if (!message.empty()) message_ = message;
  desk_.show({&journal_.run(), phase, interval, message_,
              player_ ? player_->temperature_c() : std::nullopt, waits});
}

Result<RunEnd> Runner::run() {
  if (journal_.run().open()) {
    if (auto written = journal_.append(Voided{"interrupted"}); !written) return written.error();
  }
  if (!journal_.run().over() && !desk_.unattended()) {
    auto early = pause(Phase::kReady, "waiting until everybody is ready");
    if (!early) return early.error();
    if (*early) return **early;
  }
  while (!journal_.run().over()) {
    auto early = one_trial();
    if (!early) return early.error();
    if (*early) return **early;
  }
  if (auto kept = record_note(); !kept) return kept.error();
  const Staircase& staircase = journal_.run().state().staircase();
  const std::vector<Level> counted = staircase.counted_reversals();
  const Experiment& experiment = journal_.run().header().experiment;
  const std::string given =
      counted.empty() ? std::string(name(staircase.status()))
                      : mean_decimal(counted, experiment.decimals()) + " " + experiment.unit();
  if (auto written = journal_.append(Remark{"finished", given}); !written) return written.error();
  show(Phase::kOver);
  return RunEnd::kOver;
}

Result<Runner::Early> Runner::one_trial() {
  const Trial trial = *journal_.run().state().next();
  for (const auto& wait :
       {std::function([&] { return until_ready(trial); }), std::function([&] { return rest(); })}) {
    auto early = wait();
    if (!early || *early) return early;
  }
  void_requested_ = false;
  if (auto written = journal_.append(TrialStarted{trial}); !written) return written.error();
  std::string fault;
  auto early = play(trial, fault);
  if (early && !*early && fault.empty()) early = ask(fault);
  if (!early || *early) return early;
  if (fault.empty()) {
    voids_in_a_row_ = 0;
    timeouts_in_a_row_ = 0;
    return Early{};
  }
  if (auto written = journal_.append(Voided{fault}); !written) return written.error();
  message_ = "void: " + fault;
  if (!lost_.empty()) return reconnect(std::exchange(lost_, {}));
  return handle_void(fault);
}

Result<Runner::Early> Runner::handle_void(const std::string& fault) {
  if (desk_.unattended() && fault == kTimeout) {
    if (++timeouts_in_a_row_ < kTooManyTimeouts) return Early{};
    stuck_reason_ = fault + ", again and again (response_limit_ms is " +
                    std::to_string(journal_.run().header().experiment.response_limit_ms) + ")";
    return Early{RunEnd::kStuck};
  }
  if (++voids_in_a_row_ < kTooManyVoids) return Early{};
  voids_in_a_row_ = 0;
  return desk_.unattended() ? Result<Early>(stuck(fault))
                            : pause(Phase::kPaused, "five voids in a row, the last: " + fault);
}

Runner::Early Runner::stuck(const std::string& why) {
  stuck_reason_ = "the ball does not play (" + why + ")";
  return RunEnd::kStuck;
}

Result<Runner::Early> Runner::play(const Trial& trial, std::string& fault) {
  const Experiment experiment = journal_.run().header().experiment;
  const int intervals = experiment.task == Task::kYesNo ? 1 : 2;
  std::optional<std::int64_t> not_before;
  std::optional<Problem> problem;
  for (int interval = 1; interval <= intervals && fault.empty(); ++interval) {
    const bool is_test = intervals == 1 || trial.interval_of_test == interval;
    Stimulus stimulus =
        is_test ? test_stimulus(experiment, trial.level) : reference_stimulus(experiment);
    if (trial.kind == TrialKind::kCatch) stimulus.current_a = 0.0;
    show(Phase::kInterval, interval);
    const auto played = player_->play(interval, stimulus, experiment.pattern, not_before, [&] {
      if (auto seen = poll_input(Milliseconds{0}); !seen) problem = seen.error();
      return problem || void_requested_ || stop_requested();
    });
    if (problem) return *problem;
    if (!played) {
      fault = played.error().message;
      if (played.error().failure != client::Failure::kRefused) lost_ = fault;
      return Early{};
    }
    if (auto written = journal_.append(*played); !written) return written.error();
    if (stop_requested()) return stop_early();
    fault = void_requested_ ? "by the experimenter"
                            : fault_of(*played, experiment.pattern).value_or("");
    if (played->offset_ns) not_before = *played->offset_ns + experiment.pattern.gap_ms * 1'000'000;
  }
  return Early{};
}

Result<Runner::Early> Runner::ask(std::string& fault) {
  const Experiment experiment = journal_.run().header().experiment;
  // In this order: an immediate response must not be taken for one given before the question.
  desk_.take_in();
  const auto asked_at = steady_clock::now();
  show(Phase::kQuestion);
  while (true) {
    const Input input = desk_.wait(kDeskPoll);
    // A key pressed before the question is not a response.
    const bool answers = input.kind == Input::Kind::kAnswer &&
                         fits(input.answer, experiment.task) && input.at >= asked_at;
    const std::int64_t took_ms =
        answers && input.response_ms
            ? *input.response_ms
            : std::chrono::duration_cast<Milliseconds>(input.at - asked_at).count();
    if (experiment.response_limit_ms > 0 && took_ms > experiment.response_limit_ms) {
      fault = kTimeout;
      return Early{};
    }
    if (answers) {
      if (auto written = journal_.append(Answered{input.answer, took_ms}); !written)
        return written.error();
      message_.clear();
      return Early{};
    }
    if (auto handled = handle_input(input); !handled) return handled.error();
    if (stop_requested()) return stop_early();
    if (void_requested_) {
      fault = "by the experimenter";
      return Early{};
    }
    // The trial was valid; a connection lost now does not affect it.
    if (lost_.empty()) {
      if (auto kept = player_->keep(Milliseconds{0}); !kept) lost_ = kept.error().message;
    }
  }
}

}  // namespace hedgehog::study
