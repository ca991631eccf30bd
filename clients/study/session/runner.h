// SPDX-License-Identifier: MIT
// One run with a participant: trials on the ball, responses, pauses, voids; every event is in the
// journal before it takes effect.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/study/journal/journal.h"
#include "clients/study/session/desk.h"
#include "clients/study/session/player.h"

namespace hedgehog::study {

enum class RunEnd : std::uint8_t {
  kOver,     // finished, or aborted after the maximum number of trials
  kStopped,  // by the experimenter, or by `stop`: `resume` continues
  kStuck,    // unattended, and it cannot continue: see `stuck_reason`
};

/// One thread. A ball that derates, is lost or claimed, and a lost connection pause the run until
/// they recover; the affected trial is void and repeated. A run stays with the daemon's address;
/// with another start of the daemon it continues when the experimenter confirms it, or
/// automatically if it is simulated.
class Runner {
 public:
  Runner(Journal& journal, Player player, Desk& desk, std::function<bool()> stop);

  /// EX_IOERR when the journal cannot be written.
  Result<RunEnd> run();
  /// A sentence without full stop. Empty unless the end was kStuck.
  const std::string& stuck_reason() const noexcept { return stuck_reason_; }

 private:
  /// nullopt: continue.
  using Early = std::optional<RunEnd>;

  Result<Early> one_trial();
  /// After a void: too many in a row pause or end the run.
  Result<Early> handle_void(const std::string& fault);
  Early stuck(const std::string& why);
  Result<Early> play(const Trial& trial, std::string& fault);
  Result<Early> ask(std::string& fault);
  Result<Early> until_ready(const Trial& trial);
  Result<Early> pause(Phase phase, const std::string& why);
  Result<Early> rest();
  /// Waits for the ball at the run's address.
  Result<Early> reconnect(const std::string& why);
  /// Whether the run may continue with `player_`, another start of the daemon: the experimenter
  /// decides.
  Result<Early> accept_start();
  /// Processes input outside of a question.
  Result<void> poll_input(std::chrono::milliseconds timeout);
  Result<void> handle_input(const Input& input);
  /// Records a note that is unfinished at the end.
  Result<void> record_note();
  Result<Early> stop_early();
  void show(Phase phase, int interval = 0, const std::string& message = {}, bool waits = false);
  bool stop_requested() const { return stop_requested_ || stop_(); }

  Journal& journal_;
  std::optional<Player> player_;
  client::Address address_;
  Desk& desk_;
  std::function<bool()> stop_;
  bool stop_requested_ = false;
  bool pause_requested_ = false;
  bool void_requested_ = false;
  bool continue_requested_ = false;
  /// The last failure of the connection, if it cannot be used any more.
  std::string lost_{};
  int voids_in_a_row_ = 0;
  /// Of an unattended run, in which a response in time is expected eventually.
  int timeouts_in_a_row_ = 0;
  std::string stuck_reason_{};
  std::string message_{};
};

}  // namespace hedgehog::study
