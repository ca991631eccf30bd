// SPDX-License-Identifier: MIT
// The ball during a run: one circle after another, on the daemon's clock, and nobody else's.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/connection.h"
#include "clients/study/journal/identity.h"

namespace hedgehog::study {

/// Whether the next trial would be played in full strength.
struct Readiness {
  bool ready = true;
  std::string why_not{};  // one sentence
};

/// One thread. Holds a claim on the ball, as long as it is kept, until it goes away.
class Player {
 public:
  /// The daemon tells something five times a second of its own time.
  static constexpr client::Milliseconds kSilence{5'000};
  /// A daemon that tells nothing for so long, or does not end what was stopped, counts as gone:
  /// `kSilence`, or the response timeout where that is longer.
  static client::Milliseconds max_silence() {
    return std::max(kSilence, client::response_timeout());
  }

  /// Connects, introduces itself, claims the ball. A daemon that tells nothing for `silence` counts
  /// as gone.
  static client::Outcome<Player> open(const std::vector<client::Address>& addresses,
                                      client::Milliseconds patience,
                                      client::Milliseconds silence = max_silence());

  const BallFacts& ball() const noexcept { return pin_.ball; }
  /// The ball, the daemon's address and its start.
  const Pin& pin() const noexcept { return pin_; }
  const client::Address& address() const noexcept { return connection_.address(); }
  /// How the experiment asks for more than this ball plays, as a sentence. Nothing: it does not.
  std::optional<std::string> too_much(const Experiment& experiment) const;
  std::optional<double> temperature_c() const noexcept { return temperature_c_; }

  /// Plays one interval to its end; not before the device time `not_before_ns`, if there is one.
  /// `abort` is asked all the while: true stops it (reason "stopped"). An error: the daemon is
  /// gone or silent, it never ends the circle, or it refused.
  client::Outcome<IntervalPlayed> play(int interval, const Stimulus& stimulus,
                                       const Pattern& pattern,
                                       std::optional<std::int64_t> not_before_ns,
                                       const std::function<bool()>& abort);

  /// Armed, cool enough, nothing reduced: from the daemon's forecast for the whole trial.
  client::Outcome<Readiness> readiness(const Experiment& experiment, const Trial& trial);

  /// Renews the claim when it is time, and takes in what the daemon told; waits up to `wait` for
  /// it. An error: the daemon is gone or silent.
  client::Outcome<void> keep(client::Milliseconds wait);

 private:
  Player(client::Connection connection, client::Milliseconds silence)
      : connection_(std::move(connection)), silence_(silence) {}
  client::Outcome<void> introduce();
  client::Outcome<void> claim();
  void take(const client::Notification& notification);
  client::Outcome<std::int64_t> clock_ns();

  client::Connection connection_;
  client::Milliseconds silence_;
  std::chrono::steady_clock::time_point received_ = std::chrono::steady_clock::now();
  Pin pin_{};
  double max_a_ = 0.0;
  std::int64_t device_ns_ = 0;
  std::int64_t claimed_ns_ = 0;
  std::optional<double> temperature_c_{};
  std::optional<model::Quaternion> orientation_{};
  double highest_a_ = 0.0;
  std::uint32_t effect_ = 0;
  std::optional<protocol::Event> ended_{};
};

/// How the experiment asks for more than `max_a`, as a sentence. Nothing: it does not.
std::optional<std::string> beyond(const Experiment& experiment, double max_a);

/// Why an interval makes its trial void: cut short, weaker than 98 % of what was asked, under or
/// mixed with another effect. Nothing: it is good.
std::optional<std::string> fault_of(const IntervalPlayed& played, const Pattern& pattern);

}  // namespace hedgehog::study
