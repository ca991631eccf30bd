// SPDX-License-Identifier: MIT
// Events of a run, in the order in which they are recorded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "clients/study/rules/run.h"
#include "model/quaternion.h"

namespace hedgehog::study {

/// Identification of the ball that was used.
struct BallFacts {
  std::string name{};
  std::string model{};
  std::optional<std::string> serial{};
  bool simulated = false;
  double force_n_per_a = 0.0126;  // its calibration, at the nearest pin
  friend bool operator==(const BallFacts&, const BallFacts&) = default;
};

/// Identification of its daemon.
struct DaemonFacts {
  std::string address{};   // in the format of `Address`; empty: in journals before it was recorded
  std::string start_id{};  // empty: the daemon reports none
  friend bool operator==(const DaemonFacts&, const DaemonFacts&) = default;
};

/// The first line: all inputs from which the run can be reproduced.
struct RunStarted {
  std::string participant{};
  Experiment experiment{};
  int run = 1;  // number for this participant and experiment, from 1
  RunSeeds seeds{};
  BallFacts ball{};
  /// The responses are simulated: a rehearsal.
  bool simulated_person = false;
  std::string software_version{};
  /// The experimenter's screen is also visible to the participant.
  bool blind = false;
  /// Seed of a simulated participant's responses.
  std::uint64_t person_seed = 0;
  DaemonFacts daemon{};
  friend bool operator==(const RunStarted&, const RunStarted&) = default;
};

/// The experimenter's check list. Contains the consent's reference, never the document.
struct Checklist {
  bool headphones = false;
  bool hand_on_top = false;
  std::string consent{};
  std::optional<double> hand_size_cm{};  // tip of the index finger to the wrist
  std::string dominant_hand{};           // "left", "right"
  std::string age_band{};                // "22-29"
  std::string experimenter{};            // a code, not a name
  friend bool operator==(const Checklist&, const Checklist&) = default;
};

struct TrialStarted {
  Trial trial{};
  friend bool operator==(const TrialStarted&, const TrialStarted&) = default;
};

/// One interval. Times are device time, ns.
struct IntervalPlayed {
  int interval = 1;
  Stimulus stimulus{};
  std::int64_t command_ns = 0;
  std::int64_t ack_ns = 0;
  std::optional<std::int64_t> onset_ns{};
  std::optional<std::int64_t> offset_ns{};
  std::string reason{};  // why it ended; "completed" if successful
  // nullopt: not reported by the daemon.
  std::optional<double> delivered_min{};
  std::optional<double> delivered_mean{};
  std::optional<std::int64_t> masked_ms{};
  std::optional<std::int64_t> mixed_ms{};
  std::optional<double> measured_a{};  // the maximum while it played
  std::optional<double> temperature_c{};
  /// Orientation of the ball at the end, device -> world.
  std::optional<model::Quaternion> orientation{};
  friend bool operator==(const IntervalPlayed&, const IntervalPlayed&) = default;
};

struct Answered {
  Answer answer = Answer::kNo;
  std::int64_t response_ms = 0;  // from the end of the last interval
  friend bool operator==(const Answered&, const Answered&) = default;
};

struct Voided {
  std::string reason{};
  friend bool operator==(const Voided&, const Voided&) = default;
};

/// From here on the run uses this daemon, or this start of it: confirmed by the experimenter, or
/// accepted because the run is simulated.
struct DaemonChanged {
  DaemonFacts daemon{};
  friend bool operator==(const DaemonChanged&, const DaemonChanged&) = default;
};

/// Events that do not change the state of the staircase: "note", "paused", "continued", "resumed",
/// "rest", "stopped", "finished", "blind" (from here on).
inline constexpr const char* kBallReturned = "the ball is back";  // text of "continued"
struct Remark {
  std::string kind{};
  std::string text{};
  friend bool operator==(const Remark&, const Remark&) = default;
};

using Event = std::variant<RunStarted, Checklist, TrialStarted, IntervalPlayed, Answered, Voided,
                           DaemonChanged, Remark>;

struct Line {
  std::int64_t number = 0;  // from 1, without gaps
  std::string time{};       // RFC 3339, UTC
  Event event{};
  friend bool operator==(const Line&, const Line&) = default;
};

}  // namespace hedgehog::study
