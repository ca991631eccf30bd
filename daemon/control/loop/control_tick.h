// SPDX-License-Identifier: MIT
// One tick with its inputs and outputs: gathers inputs, steps the controller, publishes outputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "daemon/control/controller.h"
#include "daemon/control/loop/latency_meter.h"
#include "daemon/control/mailbox.h"
#include "daemon/control/recording/flight_recorder.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/step_inputs.h"
#include "daemon/device/link_port.h"

namespace hedgehog::control {

/// Control thread; real-time safe except the constructor. Mailbox, port and recorder outlive it.
class ControlTick {
 public:
  /// `recorder` may be null. `speed`: ticks per real millisecond; sensor samples arrive in real
  /// time, so their age is divided by it.
  ControlTick(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
              FlightRecorder* recorder, int speed = 1) noexcept;

  /// Runs the tick `tick`, after `skipped` ones that were not executed.
  void run(model::Tick tick, std::uint32_t skipped, const LoopStatistics& statistics) noexcept;

  /// Ends all effects; from now on `run_safe` is called instead of `run`.
  void shut_down() noexcept;
  /// Sends the safe command; true once the board reports that its bridges sleep.
  bool run_safe() noexcept;
  /// Maximum number of `run_safe` ticks without that report.
  static constexpr int kMaxSafeTicks = 100;

 private:
  void gather(model::Tick tick, std::uint32_t skipped) noexcept;
  /// `sent_ns`: when the command was handed over, if requests have arrived.
  void add_up(std::uint32_t skipped, std::int64_t sent_ns) noexcept;
  void add_peak(double current_a2) noexcept;
  void send(const device::BoardCommand& command) noexcept;
  /// True: there are events for io to read.
  bool publish() noexcept;
  bool publish(const Event& event) noexcept;

  /// Events for which the queue was full. Effects cannot fill it: io reuses a place only after its
  /// last `effect_ended`, so at most two events per place are pending, with reserved capacity.
  /// Others are dropped when only that is left (the snapshot contains their state).
  static constexpr std::size_t kBacklog = 1024;
  static constexpr std::size_t kKeptForEffects = 4 * std::size_t{kEffectPlaces};

  Mailbox& mailbox_;
  device::LinkPort& port_;
  FlightRecorder* recorder_;
  int speed_;
  Controller controller_;
  StepInputs inputs_;
  EventList events_;
  StatusSnapshot snapshot_;
  std::array<Event, kBacklog> backlog_{};
  std::size_t backlog_size_ = 0;
  std::array<double, 2> peaks_a2_{};  // of the last two windows of kPeakTicks; the second goes on
  int peak_ticks_ = 0;
  static constexpr int kPeakTicks = 16;
  std::uint64_t sent_ = 0;
  std::uint64_t telemetry_count_ = 0;
  std::uint64_t safe_since_ = 0;
  LatencyMeter latency_;
  device::BoardCommand last_;
};

}  // namespace hedgehog::control
