// SPDX-License-Identifier: MIT
// Commands to the driver board and its telemetry, as values. Every byte: board-protocol.md.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/device/board_core/fault.h"
#include "model/estimate/current_accuracy.h"
#include "model/limit/limited_currents.h"
#include "model/vec3.h"

namespace hedgehog::device {

inline constexpr double kFullDuty = 32767.0;  // on the wire

/// Of the board's own rules, in BoardTelemetry.
using BoardFault = board::Fault;
using BoardMode = board::Mode;

/// One set-point. Only `LimitedCurrents` produce duties other than zero. Trivially copyable.
///
/// The holding duty maintains the requested current until the next set-point: a late host cannot
/// cause a larger one. The boost drives the current there; the board adds it only in the
/// millisecond in which the new set-point arrived.
class BoardCommand {
 public:
  /// Bridges asleep, duty 0. Always allowed.
  constexpr BoardCommand() noexcept = default;

  /// Holding duty: R I. With the boost: V = R (I - I_now e) / (1 - e) with e = exp(-R T / L), which
  /// drives I_now to I in one tick T, exact for R and L. Both are limited to the supply. Resistance
  /// and `now_a` are estimates, `supply_v` is measured, > 0. Non-finite numbers: the safe command.
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
  model::Vec3 duty() const noexcept {  // holding duty, -1..1
    return {duty_q15_[0] / kFullDuty, duty_q15_[1] / kFullDuty, duty_q15_[2] / kFullDuty};
  }
  model::Vec3 first_duty() const noexcept;  // holding and boost, -1..1

  std::uint8_t fan = 0;  // duty, 0..255
  /// A change requests the board to clear its latch and arm; set-points never do.
  std::uint8_t arm_count = 0;
  std::uint8_t boot_loader_count = 0;  // a change requests the board to enter its boot loader

 private:
  bool enable_ = false;
  std::array<std::int16_t, model::kCoils> duty_q15_{};
  std::array<std::int16_t, model::kCoils> boost_q15_{};
};

/// Windings whose current was measured. A driver's own sensor does not while its bridge brakes.
using Measured = std::array<bool, model::kCoils>;

/// Contents of the preceding frame. Trivially copyable.
struct FrameBefore {
  bool known = false;  // false: that frame was lost
  bool bridges_awake = false;
  model::Vec3 current_a;
  Measured measured{true, true, true};
};

enum class ThermistorState : std::uint8_t { kNone, kRead, kOpen, kShorted };
struct Thermistor {
  ThermistorState state = ThermistorState::kNone;
  double celsius = 0.0;  // only while kRead
};

/// Measurements of the board in its last frame. Trivially copyable.
struct BoardTelemetry {
  std::uint32_t sequence = 0;            // of this frame
  std::uint32_t set_point_sequence = 0;  // of the last set-point the board received
  std::uint32_t received_sequence = 0;   // of the last frame of any kind it accepted
  std::uint32_t board_ms = 0;            // the board's own clock
  model::Vec3 current_a;
  Measured measured{true, true, true};  // false: that `current_a` is 0 and not valid
  model::CurrentAccuracy accuracy = model::kDriverCsAccuracy;
  model::Vec3 duty;  // at the bridges over the last millisecond, -1..1; zero while they sleep
  double supply_v = 0.0;
  bool supply_current_known = false;  // drawn by the bridges, on boards that measure it
  double supply_current_a = 0.0;
  int thermistors = 1;  // 1: on the winding that the device file specifies; else one on each
  std::array<Thermistor, model::kCoils> thermistor{};
  double sensor_c = 0.0;  // first thermistor; invalid with kSensorOpen or kSensorShort
  double fan_rpm = 0.0;
  double fan_duty = 0.0;
  BoardMode mode = BoardMode::kSafe;
  bool supply_switch_closed = true;
  bool bridges_awake = false;
  std::uint8_t arm_count = 0;
  std::uint16_t faults = 0;             // bits of BoardFault, live and latched
  std::uint8_t sensor_conversions = 0;  // mod 256; constant when the sensor is no longer read
  /// 1.0 boards do not report what they measure, 1.1 boards do not report their minor version;
  /// from 1.2 on they support the boot loader frame.
  std::uint16_t protocol_version = 1;
  std::uint16_t protocol_minor = 1;
  double limit_sensor_c = 75.0;  // the board's own limits in force
  double limit_current_a = 16.5;
  double heat_used = 0.0;  // use of the fuller I^2 t budget; 1 = trip
  /// Filled in by the link, which receives every frame: control may receive only every second one.
  FrameBefore before;
};

/// The thermistor of winding `coil`, 0..2, or the only one. kNone until the board has sent it.
inline Thermistor thermistor_on(const BoardTelemetry& board, int coil) noexcept {
  return board.thermistors > 1 ? board.thermistor[static_cast<std::size_t>(coil)]
                               : Thermistor{ThermistorState::kRead, board.sensor_c};
}

/// Winding currents, A; while the bridges sleep, less than half an ampere is sensor noise and 0.
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
