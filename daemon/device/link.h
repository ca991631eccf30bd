// SPDX-License-Identifier: MIT
// The host's end of the link as a pure step: frames to send in this millisecond, received packets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/board_codec.h"
#include "daemon/device/link_port.h"

namespace hedgehog::device {

/// Frames to the board in one millisecond: a set-point, and rarely one of another type after it.
struct LinkFrames {
  Frame set_point{};
  std::optional<Frame> other;
};

/// Real-time safe: no allocation, lock, clock or syscall. One thread (the link's, the test rig's).
///
/// A tick is a millisecond, with or without a step: a late thread reports missed ones by `skip`.
///
/// A set-point that is not renewed is repeated without its boost for 19 ticks; then the safe
/// command is sent, as always while no board is present.
///
/// A change of BoardCommand::arm_count to a value other than the board's own count becomes an arm
/// request, repeated until confirmed or for 50 ticks; an old one never arms a board that appears or
/// restarts later. Start from the board's count, since another host may have armed it before. A
/// change of boot_loader_count becomes a request to the present board, for at most 50 ticks.
class Link {
 public:
  static constexpr int kOverdueTicks = 20;
  static constexpr int kAbsentTicks = 100;

  Link() noexcept = default;
  /// `limits` are sent whenever a board appears, and repeated.
  explicit Link(const BoardLimits& limits) noexcept : limits_(limits) {}

  void set_limits(const BoardLimits& limits) noexcept {  // and sends them at once
    limits_ = limits;
    limits_due_ticks_ = 0;
  }
  /// Settings of the simulated board: sent on a change, and periodically.
  void set_simulator(const SimulatorSettings& simulator) noexcept;

  /// Milliseconds without a step. Call it before passing the packets received meanwhile.
  void skip(std::uint64_t ticks) noexcept;

  /// One received packet, any bytes; any number of them before each `step`.
  void receive(std::span<const std::uint8_t> packet) noexcept;

  /// Advances by one millisecond. `command` is new if its count differs from the previous one.
  LinkFrames step(const LinkCommand& command) noexcept;
  LinkFrames step(LinkPort& port) noexcept;  // with all inputs from the port

  /// The set-point of the last `step` was written to the board at `now_ns`; for the report.
  void set_written(std::int64_t now_ns) noexcept;

  /// Received telemetry so far; presence and counters of sent frames as of the last `step`.
  const LinkReport& report() const noexcept { return report_; }
  const PlantTruth& truth() const noexcept { return truth_; }  // the simulated board's last

 private:
  void accept_telemetry(BoardTelemetry telemetry) noexcept;
  void update_presence() noexcept;
  BoardCommand choose(const LinkCommand& command) noexcept;
  void update_arm(std::uint8_t wanted) noexcept;
  void update_boot_loader(std::uint8_t wanted) noexcept;
  std::optional<Frame> next_other() noexcept;
  Frame next_simulator() noexcept;
  void merge_thermistors(BoardTelemetry& telemetry) noexcept;

  std::optional<BoardLimits> limits_;
  LinkReport report_;
  std::uint32_t sequence_ = 0;
  std::uint64_t last_count_ = 0;
  int ticks_without_command_ = kOverdueTicks;
  bool overdue_ = true;
  int ticks_without_telemetry_ = kAbsentTicks;
  bool telemetry_received_ = false;

  std::uint8_t requested_arm_ = 0;
  int arm_ticks_left_ = 0;
  /// Makes a restarted board's count continuous: the next request then differs from its own count.
  std::uint8_t arm_offset_ = 0;

  std::uint8_t requested_boot_loader_ = 0;
  int boot_loader_ticks_left_ = 0;

  int limits_due_ticks_ = 0;
  int simulator_due_ticks_ = 0;
  std::optional<SimulatorSettings> simulator_;
  int simulator_part_ = 0;  // 0: the settings themselves; from 1 on their errors
  PlantTruth truth_;
  /// Frames since the last reading of each; initially unknown.
  std::array<std::uint32_t, model::kCoils> thermistor_age_{1000, 1000, 1000};
};

}  // namespace hedgehog::device
