// SPDX-License-Identifier: MIT
// Rules that a driver board enforces independently of its host. Freestanding and fixed point, so
// that firmware and the simulated board run the same code. Rules: ../board-rules.md.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/fault.h"
#include "daemon/device/board_core/frame.h"
#include "daemon/device/board_core/heat_budget.h"
#include "daemon/device/board_core/limits.h"
#include "daemon/device/board_core/persistence.h"
#include "daemon/device/board_core/supply_excess.h"

namespace hedgehog::board {

struct ThermistorInput {
  int16_t cc = 0;  // ignored when open or shorted
  bool open = false;
  bool shorted = false;
};

/// Measurements of one millisecond.
struct BoardInputs {
  int16_t current_ma[kWindings] = {};
  /// Bit k: `current_ma[k]` was measured; otherwise it is 0 and not valid.
  uint8_t currents_measured = 7;
  /// Measured by amplifiers in the windings' leads.
  bool currents_in_line = false;
  uint16_t supply_mv = 0;  // before the supply switch
  /// Current drawn by the bridges, valid if `supply_current_measured`.
  uint16_t supply_ma = 0;
  bool supply_current_measured = false;
  /// Number of wired thermistors, 1..3.
  uint8_t thermistors = 1;
  ThermistorInput thermistor[kWindings];
  /// True in the millisecond of a new conversion.
  bool thermistors_converted = false;
  /// Bit k: bridge k signals FLT.
  uint8_t bridge_faults = 0;
  uint16_t fan_rpm = 0;
};

/// Outputs of the board until the next millisecond.
struct BoardOutputs {
  int16_t duty_q15[kWindings] = {};
  /// SLP of all bridges. When false every duty is 0.
  bool awake = false;
  bool supply_switch_closed = true;
  uint8_t fan = 0;
};

/// No thread of its own: firmware calls it from one place. Does not wait or allocate.
///
/// Only an Arm frame with a new count arms, while set-points arrive and no fault is present; the
/// next set-point after it is the first that is applied. Each fault latches.
class BoardCore {
 public:
  BoardCore() noexcept = default;
  explicit constexpr BoardCore(const BoardLimits& limits) noexcept
      : full_(limits),
        limits_(limits),
        supply_settled_(limits.supply_settled_ms),
        supply_usable_(limits.supply_settled_ms == 0) {}

  /// One packet from the host, any bytes. Its request is executed by the next `step`.
  void receive(const uint8_t* bytes, size_t length) noexcept;

  /// Advances by one millisecond.
  BoardOutputs step(const BoardInputs& inputs) noexcept;

  /// The telemetry of the last `step`, 64 bytes.
  void write_telemetry(uint8_t* frame) noexcept;

  /// The boot loader was requested before the last `step`, and the bridges have slept long enough:
  /// firmware enters it instead of running another millisecond.
  bool boot_loader_due() const noexcept { return boot_loader_due_; }

  Mode mode() const noexcept { return mode_; }
  /// Latched and live faults.
  uint16_t faults() const noexcept { return static_cast<uint16_t>(latched_ | live_); }
  uint32_t now_ms() const noexcept { return now_ms_; }
  /// Time since the last valid set-point; UINT32_MAX before the first.
  uint32_t set_point_age_ms() const noexcept { return set_point_age_ms_; }
  const BoardOutputs& outputs() const noexcept { return outputs_; }
  const BoardLimits& limits() const noexcept { return limits_; }
  /// Inputs of the last `step`; null before the first.
  const BoardInputs* last_inputs() const noexcept { return now_ms_ == 0 ? nullptr : &inputs_; }

 private:
  void tighten(const LimitsFrame& frame) noexcept;
  void age_set_point() noexcept;
  void check_inputs(const BoardInputs& inputs) noexcept;
  void follow_currents(const BoardInputs& inputs) noexcept;
  void check_current() noexcept;
  bool unexpected_current() noexcept;
  bool unmeasured_current() noexcept;
  void check_sensor(const BoardInputs& inputs) noexcept;
  void check_supply(const BoardInputs& inputs) noexcept;
  void check_dead_man() noexcept;
  void answer_arm() noexcept;
  void answer_boot_loader() noexcept;
  void decide() noexcept;
  uint8_t fan() const noexcept;
  void write_thermistors(TelemetryFrame& out) const noexcept;
  bool armed() const noexcept { return mode_ == Mode::kReady || mode_ == Mode::kDriving; }
  bool fed() const noexcept { return set_point_age_ms_ < kDeadManMs; }

  BoardLimits full_;    // as built: the budgets are tightened by a share of these
  BoardLimits limits_;  // in force
  Mode mode_ = Mode::kSafe;
  uint16_t latched_ = 0;
  uint16_t live_ = 0;
  uint32_t now_ms_ = 0;

  bool any_received_ = false;
  uint32_t received_sequence_ = 0;
  uint16_t refused_ = 0;

  SetPointFrame set_point_;
  bool set_point_new_ = false;
  /// A new set-point arrived in this millisecond: its boost applies.
  bool boosting_ = false;
  uint32_t set_point_age_ms_ = UINT32_MAX;

  bool arm_requested_ = false;
  uint8_t requested_arm_count_ = 0;
  uint8_t arm_count_ = 0;

  bool boot_loader_requested_ = false;
  bool boot_loader_due_ = false;
  Persistence asleep_{kBootLoaderMs};

  Persistence over_current_{kOverCurrentMs};
  Persistence sensor_hot_{kSensorHotMs};
  Persistence sensor_open_{kSensorBrokenMs};
  Persistence sensor_short_{kSensorBrokenMs};
  Persistence supply_{kSupplyMs};
  Persistence supply_high_{kSupplyMs};
  Persistence supply_settled_{0};
  /// The supply switch may be closed. A supply that falls leaves it so: a winding may be the load.
  bool supply_usable_ = true;
  Persistence bridge_{kBridgeFaultMs};
  Persistence stuck_{kStuckMs};
  Persistence charged_{kChargingMs};
  Persistence unexpected_{kUnexpectedMs};
  SupplyExcess excess_supply_;
  /// Winding currents, mA: measured, or decaying in the brake since the last measurement.
  int16_t flowing_ma_[kWindings] = {};
  /// Time for which a winding has been driven in one direction without a measured current, ms.
  uint32_t unmeasured_ms_[kWindings] = {};
  int8_t driven_way_[kWindings] = {1, 1, 1};
  /// Upper bound of the currents that the duties of the last milliseconds can drive, mA.
  uint32_t drivable_ma_[kWindings] = {};
  HeatBudget winding_heat_[kWindings] = {HeatBudget(kWindingTauShift), HeatBudget(kWindingTauShift),
                                         HeatBudget(kWindingTauShift)};
  HeatBudget device_heat_{kDeviceTauShift};

  BoardInputs inputs_;
  BoardOutputs outputs_;
  /// The previous outputs: those of the bridges during the measured millisecond.
  BoardOutputs before_;
  uint8_t conversions_ = 0;
  bool thermistors_known_ = false;
  uint32_t telemetry_sequence_ = 0;
};

}  // namespace hedgehog::board
