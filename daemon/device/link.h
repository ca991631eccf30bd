// SPDX-License-Identifier: MIT
// The host's end of the link as a pure step: the frames to send in this millisecond, and the
// contents of the received packets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "daemon/device/board_codec.h"
#include "daemon/device/link_port.h"

namespace hedgehog::device {

/// Frames to the board in one millisecond: always a set-point, and rarely one frame of another
/// type, to be sent after it.
struct LinkFrames {
  Frame set_point{};
  std::optional<Frame> other;
};

/// Real-time safe: no allocation, lock, clock or syscall. One thread (the link thread, or the test
/// rig).
///
/// A tick is a millisecond, with or without a step: a late thread reports missed ones by `skip`.
///
/// A set-point that is not renewed is repeated without its boost for 19 ticks; from the 20th on the
/// safe command is sent instead. While no board is present only the safe command is sent.
///
/// A change of BoardCommand::arm_count to a value other than the board's own count becomes an arm
/// request, repeated until the board confirms it or for 50 ticks; a board that appears or restarts
/// later is never armed by an old request. Start from the board's count, since another host may
/// have armed it before. A change of BoardCommand::boot_loader_count becomes a request for the boot
/// loader, repeated for at most 50 ticks, to the present board.
class Link {
 public:
  static constexpr int kOverdueTicks = 20;
  static constexpr int kAbsentTicks = 100;

  Link() noexcept = default;
  /// `limits` are sent whenever a board appears, and repeated.
  explicit Link(const BoardLimits& limits) noexcept : limits_(limits) {}

  /// Replaces the limits; sent at once and whenever a board appears.
  void set_limits(const BoardLimits& limits) noexcept {
    limits_ = limits;
    limits_due_ticks_ = 0;
  }
  /// Settings of the simulated board: sent on a change, and periodically.
  void set_simulator(const SimulatorSettings& simulator) noexcept;

  /// Milliseconds without a step. Call it before passing the packets received meanwhile.
  void skip(std::uint64_t ticks) noexcept;

  /// One received packet, any bytes; any number of them before each `step`.
  void receive(std::span<const std::uint8_t> packet) noexcept;

  /// Advances by one millisecond. `command` is the latest one of the control thread: new if its
  /// count differs from the previous one.
  LinkFrames step(const LinkCommand& command) noexcept;
  /// The same, with all inputs from the port.
  LinkFrames step(LinkPort& port) noexcept;

  /// The set-point of the last `step` was written to the board at `now_ns`; for the report.
  void set_written(std::int64_t now_ns) noexcept;

  /// Received telemetry so far; presence and counters of sent frames as of the last `step`.
  const LinkReport& report() const noexcept { return report_; }
  /// The simulated board's last report of its plant.
  const PlantTruth& truth() const noexcept { return truth_; }

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
  /// Added to the count of a restarted board, so that it is continuous for control: the next
  /// request then differs from the board's own count, whatever its value.
  std::uint8_t arm_offset_ = 0;

  std::uint8_t requested_boot_loader_ = 0;
  int boot_loader_ticks_left_ = 0;

  int limits_due_ticks_ = 0;
  int simulator_due_ticks_ = 0;
  std::optional<SimulatorSettings> simulator_;
  /// 0: the settings themselves; from 1 on their errors.
  int simulator_part_ = 0;
  PlantTruth truth_;
  /// Frames since the last reading of each thermistor; initially unknown.
  std::array<std::uint32_t, model::kCoils> thermistor_age_{1000, 1000, 1000};
};

}  // namespace hedgehog::device
