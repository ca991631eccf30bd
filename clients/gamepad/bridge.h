// SPDX-License-Identifier: MIT
// Between a gamepad's device and the daemon: tilt goes one way, effects the other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/gamepad/effect_player.h"
#include "clients/gamepad/gamepad_device.h"
#include "clients/gamepad/tilt_axes.h"
#include "clients/lib/connection.h"

namespace hedgehog::gamepad {

struct BridgeOptions {
  std::vector<client::Address> addresses{};
  TranslationOptions translation{};
  TiltOptions tilt{};
  bool once = false;  // ends with the connection instead of reconnecting
};

/// One thread, which answers a game at once whether there is a daemon or not. A game's effects end
/// with the connection and are not started again by themselves.
class Bridge {
 public:
  using Report = std::function<void(const std::string&)>;

  /// `report` gets a sentence for a person now and then.
  Bridge(GamepadDevice& device, const BridgeOptions& options, Report report);

  /// Until `stop`. An error when the device is gone, and with `once` when the daemon is.
  Result<void> run(const std::function<bool()>& stop);
  /// The ball as it is held next is the centre of the stick.
  void recentre() noexcept { axes_.recentre(); }

 private:
  /// Once around: waits for the first thing that happens, at most half a second.
  Result<void> step();
  void wait() const;
  Result<void> handle_device(TimePoint now);
  void handle(const DeviceCommand& command, TimePoint now);
  /// A daemon that is gone is no error unless `once`.
  Result<void> handle_daemon(TimePoint now);
  client::Outcome<void> connect();
  client::Outcome<void> exchange();
  void take(const client::Notification& notification);
  void move_stick(const StickPosition& position);
  void report_once(const std::string& message);

  GamepadDevice& device_;
  BridgeOptions options_;
  Report report_;
  EffectPlayer player_;
  TiltAxes axes_;
  std::optional<StickPosition> stick_;  // as last sent to the device
  std::optional<client::Connection> connection_;
  client::Backoff backoff_;
  TimePoint next_attempt_{};
  std::string reported_;
};

}  // namespace hedgehog::gamepad
