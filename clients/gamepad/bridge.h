// SPDX-License-Identifier: MIT
// Bridge between a gamepad device and the daemon: tilt in one direction, effects in the other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/gamepad/effect_player.h"
#include "clients/gamepad/gamepad_device.h"
#include "clients/gamepad/tilt_axes.h"
#include "clients/lib/ball.h"

namespace hedgehog::gamepad {

struct BridgeOptions {
  std::vector<client::Address> addresses{};
  TranslationOptions translation{};
  TiltOptions tilt{};
  bool once = false;   // ends with the connection instead of reconnecting
  bool trace = false;  // reports every command of the games
};

/// One thread, which answers a game at once whether or not the daemon is connected, connecting or
/// silent (only the look-up of a host name blocks). A game's effects end with the connection and
/// are not restarted automatically. The stick is centred without a current orientation: 100 ms
/// after the last telemetry at the latest. A daemon that does not answer, after the same 100 ms,
/// within `client::response_timeout` (2 s) is disconnected.
class Bridge {
 public:
  using Report = std::function<void(const std::string&)>;

  /// `report` receives occasional sentences for the user.
  Bridge(GamepadDevice& device, const BridgeOptions& options, Report report);

  /// Runs until `stop`. An error if the device is lost, and with `once` if the connection is.
  Result<void> run(const std::function<bool()>& stop);
  /// The next orientation of the ball becomes the centre of the stick.
  void recentre() noexcept { axes_.recentre(); }

 private:
  /// One iteration: waits for the first event, at most half a second.
  Result<void> step();
  void wait() const;
  Result<void> handle_device(TimePoint now);
  void handle(const DeviceCommand& command, TimePoint now);
  /// The errno of the response, 0 for success and for commands without a response.
  int carry_out(const DeviceCommand& command, TimePoint now);
  /// A lost connection is no error unless `once`.
  Result<void> handle_daemon(TimePoint now);
  Result<void> handle_problem();
  void on_connect(TimePoint now);
  /// No telemetry was received by `telemetry_due_`.
  void on_silence(TimePoint now);
  void take(const protocol::Reply& response);
  void take(const client::Notification& notification, TimePoint now);
  void move_stick(const StickPosition& position);
  void report_once(const std::string& message);

  GamepadDevice& device_;
  BridgeOptions options_;
  Report report_;
  EffectPlayer player_;
  TiltAxes axes_;
  std::optional<StickPosition> stick_;  // as last sent to the device
  Ball ball_;
  int connections_ = 0;  // of `ball_`, handled
  std::optional<protocol::Id> subscription_;
  TimePoint telemetry_due_{};
  std::string reported_;
};

}  // namespace hedgehog::gamepad
