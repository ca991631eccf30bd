// SPDX-License-Identifier: MIT
// Interface to the experimenter and the participant, or to their simulation: display and input.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "clients/study/journal/recorded_run.h"

namespace hedgehog::study {

enum class Phase : std::uint8_t {
  kReady,     // between trials
  kInterval,  // a circle is playing
  kQuestion,  // waiting for the participant's response
  kPaused,    // by the experimenter, the ball, or the daemon
  kRest,      // the participant may rest; the experimenter continues
  kOver,
};

/// The complete display state; the participant's screen shows only its phase and interval.
struct View {
  const RecordedRun* run = nullptr;
  Phase phase = Phase::kReady;
  int interval = 0;
  std::string message{};  // for the experimenter
  std::optional<double> temperature_c{};
  /// Waits for the experimenter to continue.
  bool waits = false;
};

struct Input {
  enum class Kind : std::uint8_t { kNone, kAnswer, kPause, kContinue, kVoid, kNote, kStop };
  Kind kind = Kind::kNone;
  Answer answer = Answer::kNo;
  /// Response time of a simulated participant; nullopt: measured.
  std::optional<std::int64_t> response_ms{};
  /// Time of the input.
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
  /// An input within `timeout`.
  virtual Input wait(std::chrono::milliseconds timeout) = 0;
  /// Reads the keys typed so far, so that they are not taken as the response to the next question.
  virtual void take_in() {}
  /// No person is present who could continue a paused run.
  virtual bool unattended() const = 0;
  /// The unfinished text of a note at the end of the run.
  virtual std::optional<std::string> unfinished_note() { return std::nullopt; }
};

}  // namespace hedgehog::study
