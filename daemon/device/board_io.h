// SPDX-License-Identifier: MIT
// Commands to the driver board and its telemetry, as values. The byte layout is in board_codec.h;
// board-protocol.md beside it documents every byte.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/device/board_core/fault.h"
#include "model/estimate/current_accuracy.h"
#include "model/limit/limited_currents.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Full duty on the wire.
inline constexpr double kFullDuty = 32767.0;

/// Of the board's own rules, in BoardTelemetry.
using BoardFault = board::Fault;
using BoardMode = board::Mode;

/// One set-point. Only `LimitedCurrents` produce duties other than zero. Trivially copyable.
///
/// Each winding has two duties. The holding duty maintains the requested current, so it may be
/// applied for as long as the set-point is not renewed: a late host cannot cause a larger current
/// than requested. The boost drives the current there; it is valid for one millisecond only, so the
/// board adds it only in the one in which a new set-point arrived.
class BoardCommand {
 public:
  /// Bridges asleep, duty 0. Always allowed.
  constexpr BoardCommand() noexcept = default;

  /// Drives `currents`. Holding duty: R I. With the boost: the voltage that drives I_now to I in
  /// one tick T, exact for a winding of R and L, V = R (I - I_now e) / (1 - e) with e = exp(-R T /
  /// L). Both are limited to the supply. `resistance_ohm` and `now_a` are the present estimates;
  /// `supply_v` the measured supply (> 0). Returns the safe command for non-finite numbers.
  static BoardCommand drive(const model::LimitedCurrents& currents,
                            const std::array<double, model::kCoils>& resistance_ohm,
                            double inductance_h, const model::Vec3& now_a,
                            double supply_v) noexcept;

  constexpr bool enable() const noexcept { return enable_; }
  /// The same without the boost, for repeated sending.
  constexpr BoardCommand held() const noexcept {
    BoardCommand command = *this;
    command.boost_q15_ = {};
    return command;
  }
  /// Holding duty of each bridge in 1/32767 of the supply, sign = direction.
  constexpr const std::array<std::int16_t, model::kCoils>& duty_q15() const noexcept {
    return duty_q15_;
  }
  /// Added to it in the first millisecond, 1/32767.
  constexpr const std::array<std::int16_t, model::kCoils>& boost_q15() const noexcept {
    return boost_q15_;
  }
  /// Holding duty, -1..1.
  model::Vec3 duty() const noexcept {
    return {duty_q15_[0] / kFullDuty, duty_q15_[1] / kFullDuty, duty_q15_[2] / kFullDuty};
  }
  /// Duty applied in the first millisecond: holding and boost, -1..1.
  model::Vec3 first_duty() const noexcept;

  /// Fan duty 0..255.
  std::uint8_t fan = 0;
  /// A change of this number requests the board to clear its latch and arm; set-points never do.
  std::uint8_t arm_count = 0;
  /// A change of this number requests the board to enter its boot loader.
  std::uint8_t boot_loader_count = 0;

 private:
  bool enable_ = false;
  std::array<std::int16_t, model::kCoils> duty_q15_{};
  std::array<std::int16_t, model::kCoils> boost_q15_{};
};

/// Per winding: its current was measured. A driver's own sensor does not measure while its bridge
/// brakes.
using Measured = std::array<bool, model::kCoils>;

/// Contents of the preceding frame. Trivially copyable.
struct FrameBefore {
  /// False when that frame was lost.
  bool known = false;
  bool bridges_awake = false;
  model::Vec3 current_a;
  Measured measured{true, true, true};
};

/// One of the board's thermistors.
enum class ThermistorState : std::uint8_t { kNone, kRead, kOpen, kShorted };
struct Thermistor {
  ThermistorState state = ThermistorState::kNone;
  double celsius = 0.0;  // only while kRead
};

/// Measurements of the board in its last frame. Trivially copyable.
struct BoardTelemetry {
  /// Number of the frame, and of the last set-point it received.
  std::uint32_t sequence = 0;
  std::uint32_t set_point_sequence = 0;
  /// Number of the last frame of any kind that the board accepted.
  std::uint32_t received_sequence = 0;
  /// The board's own clock, ms.
  std::uint32_t board_ms = 0;
  model::Vec3 current_a;
  /// False: `current_a` is 0 and not valid.
  Measured measured{true, true, true};
  model::CurrentAccuracy accuracy = model::kDriverCsAccuracy;
  /// Duty applied at the bridges over the last millisecond, -1..1; zero while they sleep.
  model::Vec3 duty;
  double supply_v = 0.0;
  /// Current drawn by the bridges, on boards that measure it.
  bool supply_current_known = false;
  double supply_current_a = 0.0;
  /// 1: on the winding that the device file specifies; otherwise one on each winding in their
  /// order.
  int thermistors = 1;
  std::array<Thermistor, model::kCoils> thermistor{};
  /// The first thermistor; invalid when kFaultSensorOpen or kFaultSensorShort is set.
  double sensor_c = 0.0;
  double fan_rpm = 0.0;
  double fan_duty = 0.0;
  BoardMode mode = BoardMode::kSafe;
  bool supply_switch_closed = true;
  bool bridges_awake = false;
  std::uint8_t arm_count = 0;
  /// Bits of BoardFault, live and latched.
  std::uint16_t faults = 0;
  /// Thermistor conversions so far, mod 256: constant when the sensor is no longer read.
  std::uint8_t sensor_conversions = 0;
  /// 1.0 boards do not report what they measure, 1.1 boards do not report their minor version; from
  /// 1.2 on they support the boot loader frame.
  std::uint16_t protocol_version = 1;
  std::uint16_t protocol_minor = 1;
  /// The board's own limits in force, and the use of the fuller of its I^2 t budgets (1 = trip).
  double limit_sensor_c = 75.0;
  double limit_current_a = 16.5;
  double heat_used = 0.0;
  /// Filled in by the link, which receives every frame: control may receive only every second one.
  FrameBefore before;
};

/// The thermistor on winding `coil`, 0..2: that winding's own, or the only one. kNone until the
/// board has sent it.
inline Thermistor thermistor_on(const BoardTelemetry& board, int coil) noexcept {
  return board.thermistors > 1 ? board.thermistor[static_cast<std::size_t>(coil)]
                               : Thermistor{ThermistorState::kRead, board.sensor_c};
}

/// Winding currents, A: as measured while the bridges are awake; while they sleep, less than half
/// an ampere is sensor noise.
inline model::Vec3 flowing_a(const BoardTelemetry& board) noexcept {
  constexpr double kStuckA = 0.5;
  const bool flows = board.bridges_awake || norm(board.current_a) > kStuckA;
  return flows ? board.current_a : model::Vec3{};
}

/// Counters of the link since the start.
struct LinkCounters {
  std::uint64_t frames_out = 0;
  std::uint64_t frames_in = 0;
  std::uint64_t lost = 0;     // gaps in the board's sequence
  std::uint64_t errors = 0;   // frames with a wrong length, CRC or version
  std::uint64_t overdue = 0;  // times the link sent the safe command: no fresh set-point for 20 ms
};

}  // namespace hedgehog::device
