// SPDX-License-Identifier: MIT
// Events of a tick other than those of effects: changes since the previous tick, overruns and
// rejected numbers.
#pragma once

#include <cstdint>
#include <type_traits>

#include "daemon/control/checks/rejected_measurements.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/event_list.h"

namespace hedgehog::control {

/// Controller state that events contain.
struct ReportInputs {
  model::Tick tick = 0;
  State state = State::kAbsent;
  Reason reason = Reason::kNoBoard;
  bool attached = false;
  bool orientation_present = false;
  bool orientation_fresh = false;
  bool derating = false;
  RejectedSet rejected;
  /// The allowed and the measured current, A, and the hottest temperature, C (infinite: unknown).
  double limit_a = 0.0;
  double current_a = 0.0;
  double temperature_c = 0.0;
  const Trip& last_trip;
};

/// Control thread; real-time safe, trivially copyable.
class EventReporter {
 public:
  /// Minimum interval between two overrun or rejection events.
  static constexpr model::Tick kReportEvery = model::kTicksPerSecond;
  /// The orientation is reported as lost after this many consecutive ticks without a fresh one, and
  /// as restored after this many with one. The first one is reported at once.
  static constexpr model::Tick kLostAfter = 50;
  static constexpr model::Tick kRestoredAfter = 2 * model::kTicksPerSecond;

  /// Called once a tick with the number of ticks `skipped` before it; those before the first tick
  /// are not counted.
  void report_overrun(std::uint32_t skipped, const ReportInputs& inputs,
                      EventList& events) noexcept;
  /// A non-finite number was replaced.
  void report_rejection(const ReportInputs& inputs, EventList& events) noexcept;
  /// Called once a tick, at its end.
  void report_changes(const ReportInputs& inputs, EventList& events) noexcept;
  /// No measurement is rejected any more, because there is another estimate: not an event.
  void clear_measurements() noexcept { reported_.rejected = {}; }

 private:
  void report_orientation(const ReportInputs& inputs, EventList& events) noexcept;
  void report_measurements(const ReportInputs& inputs, EventList& events) noexcept;

  struct Reported {
    State state = State::kAbsent;
    Reason reason = Reason::kNoBoard;
    bool attached = false;
    bool derating = false;
    RejectedSet rejected;
  };

  Reported reported_;  // as of the last events
  bool oriented_ = false;
  bool was_oriented_ = false;
  model::Tick differing_ticks_ = 0;
  bool started_ = false;
  model::Tick last_overrun_report_ = -1'000'000;
  std::uint64_t unreported_overruns_ = 0;
  model::Tick last_rejection_report_ = -1'000'000;
};

static_assert(std::is_trivially_copyable_v<EventReporter>);

}  // namespace hedgehog::control
