// SPDX-License-Identifier: MIT
// The io thread's view of the ball: latest snapshot, requests to control, fixed properties.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "daemon/config/config.h"
#include "daemon/control/mailbox.h"
#include "daemon/control/snapshot.h"
#include "daemon/device/link_port.h"
#include "daemon/server/device/outbox.h"
#include "daemon/server/device/remedy.h"
#include "model/limit/forecast.h"
#include "model/magnets/ball_geometry.h"

namespace hedgehog::server {

constexpr double kRoundingA = 1e-6;  // smaller reductions of a current are not a limitation

/// The driver board as detected on the bus.
struct BoardInfo {
  std::string problem;  // of a connected board that is not used; empty: none
  /// Of the board in use; nullopt: not reported, or no board.
  std::optional<std::string> serial;
  std::optional<std::string> firmware;
};

/// Resistance of a winding at 25 C and its changes, shares (0.05: 5 % more).
struct MeasuredR25 {
  double ohm = 0.0;
  double file_ohm = 0.0;  // from the device file
  double from_file = 0.0;
  std::optional<double> kept_ohm;  // from an earlier run; nullopt: not measured
  std::optional<double> from_kept;
};

/// io thread only.
class DeviceView {
 public:
  /// `epoch_ns`: device time of tick 0. The references must outlive it. REQUIRES: a valid geometry.
  DeviceView(const config::Config& config, control::Mailbox& mailbox, device::LinkPort& link,
             std::int64_t epoch_ns);

  void refresh();  // reads the latest snapshot
  const control::StatusSnapshot& now() const noexcept { return snapshot_; }
  std::int64_t time_ns(model::Tick tick) const noexcept {
    return epoch_ns_ + tick * model::kNanosecondsPerTick;
  }
  std::int64_t epoch_ns() const noexcept { return epoch_ns_; }

  const config::Config& config() const noexcept { return config_; }
  /// After a reload: limits (a board never widens its own) and the parts that clients may read.
  void set_config(const config::Config& config);
  const model::Limits& limits() const noexcept { return config_.limits; }
  /// The board still keeps tighter limits than these, from an earlier configuration.
  bool is_board_limited() const noexcept;
  bool simulated() const noexcept { return config_.backend == config::Backend::kSimulator; }
  // Of the pins, which a thread computes while the daemon starts: the first call may wait for it,
  // and ends the daemon if there was no memory for them.
  const model::PinArray& array() const noexcept { return pins_.get().ball->array; }
  double pin_pitch_deg() const noexcept { return pins_.get().pitch_deg; }  // model::pin_pitch_deg
  const model::PinCurves& pin_curves() const noexcept { return pins_.get().ball->curves; }
  /// Of the simulated ball, or of the device by its file: the same pins, perhaps other magnets.
  const model::PinCurves& true_pin_curves() const noexcept { return pins_.get().true_ball->curves; }
  const model::Forecaster& forecaster() const noexcept { return forecaster_; }
  model::ForecastStart forecast_start() const noexcept;
  /// Time for which full current can flow from ambient, by present estimates; nullopt: unlimited.
  std::optional<double> cold_burst_s() const noexcept;
  RemedyFacts remedy_facts() const;
  void set_board_info_source(std::function<BoardInfo()> scan) {
    board_info_source_ = std::move(scan);
  }
  /// The version of the board's frames, "1.2"; nullopt: no board is present.
  std::optional<std::string> board_protocol() const;
  BoardInfo board() const { return board_info_source_ ? board_info_source_() : BoardInfo{}; }
  /// The limiter's `allowed_a` as reported to clients: hundredths of an ampere, never above
  /// `limits().current_a`, even before control has applied new limits.
  double shown_limit_a(double allowed_a) const noexcept;
  /// Armed, but the current allowed by the thermal estimate cannot be felt: a sensor fault may have
  /// raised the estimate, which decreases slowly.
  bool too_hot() const noexcept;
  /// Reason of the present state, or of an armed ball that cannot play; nullopt: no problem.
  std::optional<std::string> reason_now() const;
  /// The temperature is known by a valid measurement; without it no current is allowed.
  bool temperature_known() const noexcept;
  double hottest_c() const noexcept;  // estimate of the hottest winding
  /// A sentence on how to arm the ball; nullopt when it is armed.
  std::optional<std::string> remedy_now() const;

  /// Requests another comfort gain; its seq, nullopt when the queue is full.
  std::optional<std::uint64_t> request_gain(ConnectionId owner, double gain);
  /// The gain in force, or the requested one until it is applied.
  double gain() const noexcept {
    return snapshot_.applied_seq < gain_seq_ ? requested_gain_ : snapshot_.gain;
  }

  /// R25 of winding `coil`, 0..2, measured in this run; nullopt: not yet.
  std::optional<MeasuredR25> r25(int coil) const noexcept;
  /// R25 from before this run; 0: never measured.
  void set_saved_r25(const std::array<double, model::kCoils>& ohm) noexcept {
    saved_r25_ohm_ = ohm;
  }

  Outbox& outbox() noexcept { return outbox_; }
  control::Mailbox& mailbox() noexcept { return mailbox_; }

  /// Orientation from an external feeder or `sim.set`. Kept fresh for the simulator.
  void set_orientation(const model::Quaternion& quaternion);
  /// An orientation has been set or measured, possibly not yet read by control.
  bool orientation_known() const noexcept {
    return snapshot_.orientation_present || orientation_.present;
  }
  const device::SimulatorSettings& simulator() const noexcept { return simulator_; }
  void set_simulator(const device::SimulatorSettings& settings);
  /// State of the simulated plant a few milliseconds ago.
  const device::PlantTruth& truth() const noexcept { return link_.truth.read(); }

 private:
  struct Pins {
    std::shared_ptr<const model::BallPins> ball;
    std::shared_ptr<const model::BallPins> true_ball;
    double pitch_deg;
  };
  static Pins pins_of(const model::BallGeometry& ball, const model::BallGeometry& true_ball);
  void set_snapshot(const control::StatusSnapshot& latest);
  void renew_orientation();

  config::Config config_;
  control::Mailbox& mailbox_;
  device::LinkPort& link_;
  std::int64_t epoch_ns_;
  std::shared_future<Pins> pins_;
  model::Forecaster forecaster_;
  Outbox outbox_;
  control::StatusSnapshot snapshot_;
  device::SimulatorSettings simulator_;
  device::OrientationSample orientation_;
  std::function<BoardInfo()> board_info_source_;
  std::array<double, model::kCoils> saved_r25_ohm_{};
  double mean_current_a_ = 0.0;
  double requested_gain_ = 1.0;
  std::uint64_t gain_seq_ = 0;
};

}  // namespace hedgehog::server
