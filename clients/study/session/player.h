// SPDX-License-Identifier: MIT
// The ball during a run: plays one circle after another, timed by the device's clock, with a claim.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/connection.h"
#include "clients/study/journal/identity.h"

namespace hedgehog::study {

/// Whether the next trial can be played at full strength.
struct Readiness {
  bool ready = true;
  std::string why_not{};  // one sentence
  /// The ball's time, if it becomes ready by cooling down.
  std::optional<std::int64_t> cooling_at_ns{};
};

/// One thread. Holds a claim on the ball, renewed by `keep`, until destruction.
class Player {
 public:
  /// Maximum time without messages; the daemon sends telemetry five times a second of device time.
  static constexpr client::Milliseconds kSilence{5'000};
  /// Maximum silence of a daemon, and maximum time to end a stopped effect, before it is considered
  /// lost: `kSilence`, or the response timeout if that is longer.
  static client::Milliseconds max_silence() {
    return std::max(kSilence, client::response_timeout());
  }

  /// Connects, sends a hello, claims the ball. A daemon that sends nothing for `silence` is
  /// considered lost.
  static client::Outcome<Player> open(const std::vector<client::Address>& addresses,
                                      client::Milliseconds timeout,
                                      client::Milliseconds silence = max_silence());

  const BallFacts& ball() const noexcept { return pin_.ball; }
  /// The ball, the daemon's address and its start id.
  const Pin& pin() const noexcept { return pin_; }
  const client::Address& address() const noexcept { return connection_.address(); }
  /// A sentence if the experiment exceeds the current limit of this ball; nullopt: it does not.
  std::optional<std::string> too_much(const Experiment& experiment) const;
  std::optional<double> temperature_c() const noexcept { return temperature_c_; }

  /// Plays one interval to its end; not before the device time `not_before_ns`, if given. `abort`
  /// is polled meanwhile: true stops it (reason "stopped"). Errors: the connection is lost or
  /// silent, the end of the circle is never reported, or the request was refused.
  client::Outcome<IntervalPlayed> play(int interval, const Stimulus& stimulus,
                                       const Pattern& pattern,
                                       std::optional<std::int64_t> not_before_ns,
                                       const std::function<bool()>& abort);

  /// Armed, cool enough, not derated: from the daemon's forecast for the whole trial.
  client::Outcome<Readiness> readiness(const Experiment& experiment, const Trial& trial);

  /// Renews the claim when due, and processes notifications; waits up to `wait` for them. An error:
  /// the connection is lost or silent.
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

/// A sentence if the experiment exceeds `max_a`; nullopt: it does not.
std::optional<std::string> beyond(const Experiment& experiment, double max_a);

/// Why an interval makes its trial void: cut short, weaker than 98 % of the request, masked by or
/// mixed with another effect. nullopt: it is valid.
std::optional<std::string> fault_of(const IntervalPlayed& played, const Pattern& pattern);

}  // namespace hedgehog::study
