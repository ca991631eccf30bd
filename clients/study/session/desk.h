// SPDX-License-Identifier: MIT
// The two people of a session, or the programs that stand in for them: what they see, what they do.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

enum class Phase : std::uint8_t {
  kReady,     // between trials
  kInterval,  // a circle is being played
  kQuestion,  // the participant is asked
  kPaused,    // by the experimenter, the ball, or the daemon
  kRest,      // the participant may rest; the experimenter continues
  kOver,
};

/// The whole picture; the participant is shown its phase and interval and nothing else.
struct View {
  const RecordedRun* run = nullptr;
  Phase phase = Phase::kReady;
  int interval = 0;
  std::string message{};  // for the experimenter
  std::optional<double> temperature_c{};
  /// Nothing goes on before the experimenter says so.
  bool waits = false;
};

struct Input {
  enum class Kind : std::uint8_t { kNone, kAnswer, kPause, kContinue, kVoid, kNote, kStop };
  Kind kind = Kind::kNone;
  Answer answer = Answer::kNo;
  /// Of an answer, when it is not to be measured: a simulated person's.
  std::optional<std::int64_t> response_ms{};
  /// When it was done.
  std::chrono::steady_clock::time_point at = std::chrono::steady_clock::now();
  std::string text{};  // of a note
};

class Desk {
 public:
  Desk() = default;
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;
  virtual ~Desk() = default;

  virtual void show(const View& view) = 0;
  /// What somebody did within `patience`.
  virtual Input wait(std::chrono::milliseconds patience) = 0;
  /// What was typed until now was typed before now: no answer to what is asked from now on.
  virtual void take_in() {}
  /// Nobody is there to continue what needs a person.
  virtual bool unattended() const = 0;
  /// What somebody has typed of a note when there is no more time to end it.
  virtual std::optional<std::string> unfinished_note() { return std::nullopt; }
};

}  // namespace hedgehog::study
