// SPDX-License-Identifier: MIT
// Frames of board_core/frame.h <-> values of board_io.h, SI units. Any thread, real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/board_core/frame.h"
#include "daemon/device/board_io.h"
#include "daemon/device/simulator/plant_truth.h"
#include "daemon/device/simulator/simulator_settings.h"
#include "model/limit/limits.h"

namespace hedgehog::device {

using Frame = std::array<std::uint8_t, board::kFrameSize>;

/// Tighter limits than the board's own (board_core/limits.h); wider values have no effect.
struct BoardLimits {
  double sensor_c = 75.0;
  double current_a = 16.5;
  double heat = 1.0;  // share of the board's own I^2 t budgets, 0..1

  /// For a host that keeps to `limits`: 5 K above its trip and a tenth above its current, never
  /// more than 75 C and 16.5 A.
  static BoardLimits of(const model::Limits& limits) noexcept;
  bool wider_than(const BoardLimits& other) const noexcept {  // `other`: in force on the board
    return sensor_c > other.sensor_c || current_a > other.current_a || heat > other.heat;
  }
  friend bool operator==(const BoardLimits&, const BoardLimits&) noexcept = default;
};

Frame encode_set_point(const BoardCommand& command, std::uint32_t sequence) noexcept;
Frame encode_arm(std::uint8_t count, std::uint32_t sequence) noexcept;
Frame encode_boot_loader(std::uint32_t sequence) noexcept;
Frame encode_limits(const BoardLimits& limits, std::uint32_t sequence) noexcept;
/// Without the errors, each of which is a separate frame.
Frame encode_simulator(const SimulatorSettings& settings, std::uint32_t sequence) noexcept;
/// Error `index` of `list`. REQUIRES: `index` < `list.count`.
Frame encode_simulator_error(const SimulatorErrorList& list, std::uint8_t index,
                             std::uint32_t sequence) noexcept;

struct DecodedTelemetry {
  board::FrameError error = board::FrameError::kNone;
  BoardTelemetry telemetry;  // valid when `error` is kNone
};

/// Accepts any bytes. A well-formed frame of another type counts as kType.
DecodedTelemetry decode_telemetry(std::span<const std::uint8_t> packet) noexcept;

/// True state of the simulated board's plant; nullopt: another packet.
std::optional<PlantTruth> decode_truth(std::span<const std::uint8_t> packet) noexcept;

/// For the simulated board.
SimulatorSettings decode_simulator(std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;
Frame encode_truth(const PlantTruth& truth, std::uint32_t sequence) noexcept;

/// Assembles a list of errors from frames that may be lost or repeated; for the simulated board.
class SimulatorErrorReader {
 public:
  /// Returns a newly completed list, or nullopt. Accepts any bytes of that type.
  std::optional<SimulatorErrorList> take(
      std::span<const std::uint8_t, board::kFrameSize> frame) noexcept;

 private:
  SimulatorErrorList list_;
  std::uint64_t arrived_ = 0;  // bit n: error n
  bool begun_ = false;
  bool taken_ = false;
};

}  // namespace hedgehog::device
