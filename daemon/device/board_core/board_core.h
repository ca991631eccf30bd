// SPDX-License-Identifier: MIT
// The rules that a driver board keeps by itself, whatever its host does. Freestanding and fixed
// point, so that firmware and the simulated board run the same lines. Rules: ../board-rules.md.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/frame.h"
#include "daemon/device/board_core/heat_budget.h"
#include "daemon/device/board_core/limits.h"
#include "daemon/device/board_core/persistence.h"

namespace hedgehog::board {

/// Bits as in device::BoardFault.
enum Fault : uint16_t {
  kDeadMan = 1u << 0,
  kOverCurrent = 1u << 1,
  kOverHeat = 1u << 2,
  kHeatBudget = 1u << 3,
  kBridge = 1u << 4,
  kSensorOpen = 1u << 5,
  kSensorShort = 1u << 6,
  kStuckBridge = 1u << 7,
  kSupply = 1u << 8,
  kUnexpectedCurrent = 1u << 9,
  kCurrentSense = 1u << 10,
};

/// Values as in device::BoardMode.
enum class Mode : uint8_t {
  kSafe = 0,     // since power-up: never armed
  kReady = 1,    // armed, bridges asleep
  kDriving = 2,  // armed, bridges awake
  kLatched = 3,  // a fault: bridges asleep until armed
};

struct ThermistorInput {
  int16_t cc = 0;  // ignored when open or shorted
  bool open = false;
  bool shorted = false;
};

/// What the board measured in this millisecond.
struct BoardInputs {
  int16_t current_ma[kWindings] = {};
  /// Bit k: `current_ma[k]` was measured; otherwise it is 0 and says nothing.
  uint8_t currents_measured = 7;
  /// By amplifiers in the windings' leads.
  bool currents_in_line = false;
  uint16_t supply_mv = 0;  // before the supply switch
  /// What the bridges draw, when `supply_current_measured`.
  uint16_t supply_ma = 0;
  bool supply_current_measured = false;
  /// So many are wired, 1..3.
  uint8_t thermistors = 1;
  ThermistorInput thermistor[kWindings];
  /// They have been converted anew.
  bool thermistors_converted = false;
  /// Bit k: bridge k signals FLT.
  uint8_t bridge_faults = 0;
  uint16_t fan_rpm = 0;
};

/// What the board does until the next millisecond.
struct BoardOutputs {
  int16_t duty_q15[kWindings] = {};
  /// SLP of all bridges. When false every duty is 0.
  bool awake = false;
  bool supply_switch_closed = true;
  uint8_t fan = 0;
};

/// No thread of its own: firmware calls it from one place. Nothing in it waits or allocates.
///
/// Armed is only what an Arm frame with a new count makes so, while set-points arrive and no fault
/// is there; the next set-point after it is the first that is obeyed. Each fault latches.
class BoardCore {
 public:
  BoardCore() noexcept = default;
  explicit BoardCore(const BoardLimits& limits) noexcept : full_(limits), limits_(limits) {}

  /// One packet from the host, any bytes. What it asks for is done by the next `step`.
  void receive(const uint8_t* bytes, size_t length) noexcept;

  /// One millisecond.
  BoardOutputs step(const BoardInputs& inputs) noexcept;

  /// The telemetry of the last `step`, 64 bytes.
  void write_telemetry(uint8_t* frame) noexcept;

  /// The last `step` was asked for the boot loader, and the bridges have slept for long enough:
  /// firmware goes there instead of into another millisecond.
  bool boot_loader_due() const noexcept { return boot_loader_due_; }

  Mode mode() const noexcept { return mode_; }
  /// Latched and live.
  uint16_t faults() const noexcept { return static_cast<uint16_t>(latched_ | live_); }
  uint32_t now_ms() const noexcept { return now_ms_; }
  /// Since the last valid set-point; UINT32_MAX before the first.
  uint32_t set_point_age_ms() const noexcept { return set_point_age_ms_; }
  const BoardOutputs& outputs() const noexcept { return outputs_; }
  const BoardLimits& limits() const noexcept { return limits_; }
  /// What the last `step` was given; null before the first.
  const BoardInputs* measured_last() const noexcept { return now_ms_ == 0 ? nullptr : &inputs_; }

 private:
  void tighten(const LimitsFrame& frame) noexcept;
  void age_set_point() noexcept;
  void judge(const BoardInputs& inputs) noexcept;
  void follow_currents(const BoardInputs& inputs) noexcept;
  void judge_current() noexcept;
  bool unexpected_current() noexcept;
  bool unmeasured_current() noexcept;
  void judge_sensor(const BoardInputs& inputs) noexcept;
  void judge_dead_man() noexcept;
  void answer_arm() noexcept;
  void answer_boot_loader() noexcept;
  void decide() noexcept;
  uint8_t fan() const noexcept;
  void write_thermistors(TelemetryFrame& out) const noexcept;
  bool armed() const noexcept { return mode_ == Mode::kReady || mode_ == Mode::kDriving; }
  bool fed() const noexcept { return set_point_age_ms_ < kDeadManMs; }

  BoardLimits full_;    // as built: the budgets tighten by a share of these
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
  /// A new set-point arrived in this millisecond: its boost counts.
  bool boosting_ = false;
  uint32_t set_point_age_ms_ = UINT32_MAX;

  bool arm_asked_ = false;
  uint8_t arm_asked_count_ = 0;
  uint8_t arm_count_ = 0;

  bool boot_loader_asked_ = false;
  bool boot_loader_due_ = false;
  Persistence asleep_{kBootLoaderMs};

  Persistence over_current_{kOverCurrentMs};
  Persistence sensor_hot_{kSensorHotMs};
  Persistence sensor_open_{kSensorBrokenMs};
  Persistence sensor_short_{kSensorBrokenMs};
  Persistence supply_{kSupplyMs};
  Persistence bridge_{kBridgeFaultMs};
  Persistence stuck_{kStuckMs};
  Persistence unexpected_{kUnexpectedMs};
  Persistence excess_supply_{kExcessSupplyMs};
  /// What flows, mA: as measured, or as it dies away in the brake since then.
  int16_t flowing_ma_[kWindings] = {};
  /// Milliseconds for which a winding has been driven one way without its current measured.
  uint32_t unmeasured_ms_[kWindings] = {};
  int8_t driven_way_[kWindings] = {1, 1, 1};
  /// The most that the duties of the last milliseconds can have made flow, mA.
  uint32_t drivable_ma_[kWindings] = {};
  HeatBudget winding_heat_[kWindings] = {HeatBudget(kWindingTauShift), HeatBudget(kWindingTauShift),
                                         HeatBudget(kWindingTauShift)};
  HeatBudget device_heat_{kDeviceTauShift};

  BoardInputs inputs_;
  BoardOutputs outputs_;
  /// The outputs before: what the bridges did during the millisecond that was measured.
  BoardOutputs before_;
  uint8_t conversions_ = 0;
  bool thermistors_known_ = false;
  uint32_t telemetry_sequence_ = 0;
};

}  // namespace hedgehog::board
