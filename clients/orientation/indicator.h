// SPDX-License-Identifier: MIT
// The orientation indicator of the thesis (section 4.2): the pins on the upper side come out,
// however the ball is turned.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "clients/lib/connection.h"
#include "model/vec3.h"

namespace hedgehog::client {

/// Who keeps the push upwards: this program over the network, or the daemon by a world-frame
/// effect.
enum class Loop : std::uint8_t { kClient, kDaemon };

/// `pulse`: 12 A in 15 % of the time, twice a second: 4.65 A rms, which can flow for ever and is
/// felt better than `steady`: 5 A all the time, of which the thesis found that the direction is
/// hard to tell (section 4.2).
enum class Style : std::uint8_t { kPulse, kSteady };

struct IndicatorOptions {
  Loop loop = Loop::kDaemon;
  Style style = Style::kPulse;
  /// How long; nothing: until the person interrupts.
  std::optional<std::chrono::milliseconds> duration;
};

/// What the indicator tells while it runs, about once a second.
struct IndicatorReport {
  /// Against gravity, in the device frame; nothing: the orientation is not known.
  std::optional<model::Vec3> up;
  /// The pin that the field points at, and the force there; nothing while it does not push.
  std::optional<std::int64_t> pin;
  double force_n = 0.0;
  /// Of the hottest winding; nothing: not known.
  std::optional<double> temperature_c;
};

/// One thread. Its effect ends when it does, at the latest with its connection.
class Indicator {
 public:
  Indicator(Connection& connection, const IndicatorOptions& options);

  /// Until `stop` says so or the duration is over; an error when the daemon is gone, or when
  /// somebody ended the push (kRefused).
  Outcome<void> run(const std::function<bool()>& stop,
                    const std::function<void(const IndicatorReport&)>& report);

 private:
  using Clock = std::chrono::steady_clock;

  Outcome<void> start();
  Outcome<void> play(const std::optional<model::Vec3>& direction);
  Outcome<void> take(const Notification& notification,
                     const std::function<void(const IndicatorReport&)>& report);
  /// With each telemetry: its rate, like the lease, counts the device's time.
  Outcome<void> renew();
  void take(const protocol::Event& event);
  Outcome<void> follow(const protocol::Status& status);
  /// An error once the effect was ended by somebody else and the daemon stays.
  Outcome<void> check_ended() const;

  Connection& connection_;
  IndicatorOptions options_;
  std::uint32_t effect_ = 0;
  bool lapsed_ = false;
  bool shutting_down_ = false;
  std::optional<std::string> ended_;
  Clock::time_point ended_at_{};
  Clock::time_point started_at_{};
  Clock::time_point reported_{};
};

}  // namespace hedgehog::client
