// SPDX-License-Identifier: MIT
#include "daemon/control/event_reporter.h"

namespace hedgehog::control {
namespace {

Event event_of(EventType type, const ReportInputs& inputs) noexcept {
  Event event;
  event.type = type;
  event.state = inputs.state;
  event.reason = inputs.reason;
  event.tick = inputs.tick;
  event.trip = type == EventType::kStateChanged && inputs.last_trip.tick == inputs.tick;
  event.limit_a = inputs.limit_a;
  event.current_a = inputs.current_a;
  event.temperature_c = inputs.temperature_c;
  if (event.trip) event.disagreement = inputs.last_trip.disagreement;
  return event;
}

void report(EventType type, const ReportInputs& inputs, EventList& events) noexcept {
  events.push(event_of(type, inputs));
}

}  // namespace

void EventReporter::report_overrun(std::uint32_t skipped, const ReportInputs& inputs,
                                   EventList& events) noexcept {
  unreported_overruns_ += started_ ? skipped : 0;
  started_ = true;
  if (unreported_overruns_ == 0 || inputs.tick - last_overrun_report_ < kReportEvery) return;
  Event overrun = event_of(EventType::kOverrun, inputs);
  overrun.count = unreported_overruns_;
  events.push(overrun);
  last_overrun_report_ = inputs.tick;
  unreported_overruns_ = 0;
}

void EventReporter::report_rejection(const ReportInputs& inputs, EventList& events) noexcept {
  if (inputs.tick - last_rejection_report_ < kReportEvery) return;
  last_rejection_report_ = inputs.tick;
  report(EventType::kRejectedNumber, inputs, events);
}

void EventReporter::report_changes(const ReportInputs& inputs, EventList& events) noexcept {
  if (inputs.attached != reported_.attached) {
    report(inputs.attached ? EventType::kDeviceAttached : EventType::kDeviceDetached, inputs,
           events);
  }
  if (inputs.state != reported_.state || inputs.reason != reported_.reason)
    report(EventType::kStateChanged, inputs, events);
  report_orientation(inputs, events);
  report_measurements(inputs, events);
  if (inputs.derating != reported_.derating) {
    report(inputs.derating ? EventType::kDeratingStarted : EventType::kDeratingEnded, inputs,
           events);
  }
  reported_ = {inputs.state, inputs.reason, inputs.attached, inputs.derating, inputs.rejected};
}

void EventReporter::report_orientation(const ReportInputs& inputs, EventList& events) noexcept {
  if (!inputs.orientation_present) return;
  const bool fresh = inputs.orientation_fresh;
  if (fresh == oriented_) {
    differing_ticks_ = 0;
    return;
  }
  // Counts executed ticks, so that one long gap under system load is not a loss.
  ++differing_ticks_;
  const model::Tick hold = !fresh ? kLostAfter : was_oriented_ ? kRestoredAfter : 0;
  if (differing_ticks_ <= hold) return;
  oriented_ = fresh;
  was_oriented_ = true;
  differing_ticks_ = 0;
  report(fresh ? EventType::kOrientationRestored : EventType::kOrientationLost, inputs, events);
}

void EventReporter::report_measurements(const ReportInputs& inputs, EventList& events) noexcept {
  if (inputs.rejected == reported_.rejected) return;
  for (int i = 0; i < RejectedSet::kSources; ++i) {
    const bool rejected = inputs.rejected.contains(i);
    if (rejected == reported_.rejected.contains(i)) continue;
    Event event = event_of(
        rejected ? EventType::kMeasurementRejected : EventType::kMeasurementAccepted, inputs);
    event.disagreement = RejectedSet::source(i);
    events.push(event);
  }
}

}  // namespace hedgehog::control
