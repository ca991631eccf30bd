// SPDX-License-Identifier: MIT
// The events of a tick that are no effect's: what changed since the last one, and complaints.
#pragma once

#include <cstdint>
#include <type_traits>

#include "daemon/control/snapshot.h"
#include "daemon/control/state/event_list.h"

namespace hedgehog::control {

/// What events show of the moment.
struct ReportInputs {
  model::Tick tick = 0;
  State state = State::kAbsent;
  Reason reason = Reason::kNoBoard;
  bool attached = false;
  bool orientation_present = false;
  bool orientation_fresh = false;
  bool derating = false;
  /// The current allowed and the one measured, A, and the hottest temperature, C (infinite: nothing
  /// is known).
  double limit_a = 0.0;
  double current_a = 0.0;
  double temperature_c = 0.0;
  const Trip& last_trip;
};

/// Control thread; real-time safe, trivially copyable.
class EventReporter {
 public:
  /// How often the same complaint is worth an event.
  static constexpr model::Tick kReportEvery = model::kTicksPerSecond;
  /// An orientation is reported as lost once none was fresh for so many ticks on end, and as
  /// restored once it was fresh for so many. The first one is reported at once.
  static constexpr model::Tick kLostAfter = 50;
  static constexpr model::Tick kRestoredAfter = 2 * model::kTicksPerSecond;

  /// Once a tick: so many were `skipped` before it. Those before the first were nobody's.
  void report_overrun(std::uint32_t skipped, const ReportInputs& inputs,
                      EventList& events) noexcept;
  /// A number that was not finite was replaced.
  void report_rejection(const ReportInputs& inputs, EventList& events) noexcept;
  /// Once a tick, at its end.
  void report_changes(const ReportInputs& inputs, EventList& events) noexcept;

 private:
  void report_orientation(const ReportInputs& inputs, EventList& events) noexcept;

  struct Reported {
    State state = State::kAbsent;
    Reason reason = Reason::kNoBoard;
    bool attached = false;
    bool derating = false;
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
