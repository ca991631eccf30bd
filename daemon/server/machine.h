// SPDX-License-Identifier: MIT
// The ball as io sees it: the latest snapshot, the way to ask the control thread for something, and
// what is fixed about the device.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "daemon/config/config.h"
#include "daemon/control/mailbox.h"
#include "daemon/control/snapshot.h"
#include "daemon/device/link_port.h"
#include "daemon/server/outbox.h"
#include "daemon/server/remedy.h"
#include "model/forecast.h"
#include "model/magnets/pin_curves.h"
#include "model/pin_array.h"

namespace hedgehog::server {

/// A current that is less by no more than this is not reduced, only rounded.
constexpr double kRoundingA = 1e-6;

/// The driver board as the bus shows it.
struct BoardSeen {
  /// Why one that is connected is not used; empty: nothing speaks against it.
  std::string trouble;
  /// Of the one that is in use; nullopt: it does not say, or there is none.
  std::optional<std::string> serial;
  std::optional<std::string> firmware;
};

/// io thread only.
class Machine {
 public:
  /// `epoch_ns`: device time of tick 0. The references must outlive the machine.
  Machine(const config::Config& config, control::Mailbox& mailbox, device::LinkPort& link,
          std::int64_t epoch_ns);

  /// Takes the latest snapshot.
  void refresh();
  const control::StatusSnapshot& now() const noexcept { return snapshot_; }
  std::int64_t time_ns(model::Tick tick) const noexcept {
    return epoch_ns_ + tick * model::kNanosecondsPerTick;
  }
  std::int64_t epoch_ns() const noexcept { return epoch_ns_; }

  const config::Config& config() const noexcept { return config_; }
  /// After a reload: limits (a board never widens its own) and what a client may see of the
  /// configuration.
  void set_config(const config::Config& config);
  const model::Limits& limits() const noexcept { return config_.limits; }
  /// The board still keeps to tighter limits than these, of an earlier configuration.
  bool board_holds_back() const noexcept;
  bool simulated() const noexcept { return config_.backend == config::Backend::kSimulator; }
  const model::PinArray& array() const noexcept { return array_; }
  const model::PinCurves& pin_curves() const noexcept { return pin_curves_; }
  const model::Forecaster& forecaster() const noexcept { return forecaster_; }
  model::ForecastStart forecast_start() const noexcept;
  /// A thermometer on the ball's skin allows less than `current_a` now; no forecast knows the skin.
  bool skin_reduces(double current_a) const noexcept;
  RemedyFacts remedy_facts() const;
  /// `look`: how to see the board on its bus.
  void watch_board(std::function<BoardSeen()> look) { look_at_board_ = std::move(look); }
  BoardSeen board() const { return look_at_board_ ? look_at_board_() : BoardSeen{}; }
  /// Why the ball is not armed, as a sentence; nullopt when it is.
  std::optional<std::string> remedy_now() const;

  /// Asks for another comfort gain; its seq, nullopt when there is no room.
  std::optional<std::uint64_t> ask_gain(ConnectionId owner, double gain);
  /// In force, or asked for and about to be.
  double gain() const noexcept {
    return snapshot_.applied_seq < gain_seq_ ? asked_gain_ : snapshot_.gain;
  }

  Outbox& outbox() noexcept { return outbox_; }
  control::Mailbox& mailbox() noexcept { return mailbox_; }

  /// Orientation from outside: an external feeder, or `sim.set`. Kept fresh for the simulator.
  void set_orientation(const model::Quaternion& quaternion);
  /// Some orientation has been given or measured; also when control has not looked yet.
  bool orientation_known() const noexcept {
    return snapshot_.orientation_present || orientation_.present;
  }
  const device::SimulatorSettings& simulator() const noexcept { return simulator_; }
  void set_simulator(const device::SimulatorSettings& settings);

 private:
  void keep_orientation_fresh();

  config::Config config_;
  control::Mailbox& mailbox_;
  device::LinkPort& link_;
  std::int64_t epoch_ns_;
  const model::PinArray& array_;
  const model::PinCurves& pin_curves_;
  model::Forecaster forecaster_;
  Outbox outbox_;
  control::StatusSnapshot snapshot_;
  device::SimulatorSettings simulator_;
  device::OrientationSample orientation_;
  std::function<BoardSeen()> look_at_board_;
  double mean_current_a_ = 0.0;
  double asked_gain_ = 1.0;
  std::uint64_t gain_seq_ = 0;
};

}  // namespace hedgehog::server
