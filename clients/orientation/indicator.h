// SPDX-License-Identifier: MIT
// The orientation indicator of the thesis (section 4.2): the pins on the upper side come out,
// whatever the orientation of the ball.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "clients/lib/connection.h"
#include "model/vec3.h"

namespace hedgehog::client {

/// Which loop keeps the push upwards: this program over the network, or the daemon by a world-frame
/// effect.
enum class Loop : std::uint8_t { kClient, kDaemon };

/// `pulse`: 12 A for 15 % of the time, twice a second: 4.65 A rms, which is sustainable and more
/// perceptible than `steady`: 5 A continuously, whose direction is hard to recognize according to
/// the thesis (section 4.2).
enum class Style : std::uint8_t { kPulse, kSteady };

struct IndicatorOptions {
  Loop loop = Loop::kDaemon;
  Style style = Style::kPulse;
  /// Duration; nullopt: until interrupted.
  std::optional<std::chrono::milliseconds> duration;
};

/// Report of the indicator, about once a second.
struct IndicatorReport {
  /// Unit vector against gravity, in the device frame; nullopt: the orientation is unknown.
  std::optional<model::Vec3> up;
  /// The pin that the field points at, and the force there; nullopt while it does not push.
  std::optional<std::int64_t> pin;
  double force_n = 0.0;
  /// Of the hottest winding; nullopt: unknown.
  std::optional<double> temperature_c;
};

/// One thread. Its effect ends with it, at the latest with the connection.
class Indicator {
 public:
  Indicator(Connection& connection, const IndicatorOptions& options);

  /// Runs until `stop` returns true or the duration has elapsed; an error if the connection is
  /// lost, or if another client ended the push (kRefused).
  Outcome<void> run(const std::function<bool()>& stop,
                    const std::function<void(const IndicatorReport&)>& report);

 private:
  using Clock = std::chrono::steady_clock;

  Outcome<void> start();
  Outcome<void> play(const std::optional<model::Vec3>& direction);
  Outcome<void> take(const Notification& notification,
                     const std::function<void(const IndicatorReport&)>& report);
  /// At each telemetry message: its rate, like the lease, is in device time.
  Outcome<void> renew();
  void take(const protocol::Event& event);
  Outcome<void> follow(const protocol::Status& status);
  /// An error once the effect was ended by another client and the daemon does not shut down.
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
