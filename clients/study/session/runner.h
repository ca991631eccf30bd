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
  kStuck,    // unattended, and it cannot continue: see `why_stuck`
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
  const std::string& why_stuck() const noexcept { return why_stuck_; }

 private:
  /// nullopt: continue.
  using Early = std::optional<RunEnd>;

  Result<Early> one_trial();
  /// After a void: too many in a row pause or end the run.
  Result<Early> look_at(const std::string& fault);
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
  Result<void> measured_now(std::chrono::milliseconds patience);
  Result<void> heed(const Input& input);
  /// Records a note that is unfinished at the end.
  Result<void> keep_note();
  Result<Early> leave();
  void show(Phase phase, int interval = 0, const std::string& message = {}, bool waits = false);
  bool asked_to_stop() const { return stop_asked_ || stop_(); }

  Journal& journal_;
  std::optional<Player> player_;
  client::Address address_;
  Desk& desk_;
  std::function<bool()> stop_;
  bool stop_asked_ = false;
  bool pause_asked_ = false;
  bool void_asked_ = false;
  bool continue_asked_ = false;
  /// The last failure of the connection, if it cannot be used any more.
  std::string lost_{};
  int voids_in_a_row_ = 0;
  /// Of an unattended run, in which a response in time is expected eventually.
  int timeouts_in_a_row_ = 0;
  std::string why_stuck_{};
  std::string message_{};
};

}  // namespace hedgehog::study
