// SPDX-License-Identifier: MIT
// One run with a person: trials on the ball, answers, pauses, voids; every event in the journal
// before anything follows from it.
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
  kOver,     // finished, or given up after the most trials
  kStopped,  // by the experimenter, or by `stop`: `resume` goes on
  kStuck,    // unattended, and it does not go on: `why_stuck` says why
};

/// One thread. A ball that derates, is lost or claimed, and a daemon that goes away, pause the run
/// until they are back; the trial that they spoilt is void and repeated. A run stays with the
/// daemon's address; with another start of the daemon it goes on when the experimenter says so, or
/// when a program answers.
class Runner {
 public:
  Runner(Journal& journal, Player player, Desk& desk, std::function<bool()> stop);

  /// EX_IOERR when the journal cannot be written.
  Result<RunEnd> run();
  /// A sentence without its end. Empty unless the end was kStuck.
  const std::string& why_stuck() const noexcept { return why_stuck_; }

 private:
  /// nothing: go on.
  using Early = std::optional<RunEnd>;

  Result<Early> one_trial();
  /// After a void: too many in a row are not gone on with.
  Result<Early> look_at(const std::string& fault);
  Early stuck(const std::string& why);
  Result<Early> play(const Trial& trial, std::string& fault);
  Result<Early> ask(std::string& fault);
  Result<Early> until_ready(const Trial& trial);
  Result<Early> pause(Phase phase, const std::string& why);
  Result<Early> rest();
  /// Waits for the ball at the run's address.
  Result<Early> reconnect(const std::string& why);
  /// Whether the run may go on with `player_`, another start of the daemon: the experimenter's
  /// word.
  Result<Early> accept_start();
  /// Takes in what people do outside of a question.
  Result<void> measured_now(std::chrono::milliseconds patience);
  Result<void> heed(const Input& input);
  /// A note that is being typed at the end is written down as far as it is.
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
  /// The daemon's last failure, if the connection is of no further use.
  std::string lost_{};
  int voids_in_a_row_ = 0;
  /// Of somebody unattended, who answers in time sooner or later.
  int timeouts_in_a_row_ = 0;
  std::string why_stuck_{};
  std::string message_{};
};

}  // namespace hedgehog::study
