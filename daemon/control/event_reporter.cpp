// SPDX-License-Identifier: MIT
#include "daemon/control/event_reporter.h"

namespace hedgehog::control {
namespace {

void report(EventType type, const ReportInputs& inputs, EventList& events,
            std::uint64_t count = 0) noexcept {
  Event event;
  event.type = type;
  event.state = inputs.state;
  event.reason = inputs.reason;
  event.tick = inputs.tick;
  event.trip = type == EventType::kStateChanged && inputs.last_trip.tick == inputs.tick;
  event.limit_a = inputs.limit_a;
  event.current_a = inputs.current_a;
  event.temperature_c = inputs.temperature_c;
  event.count = count;
  if (event.trip) event.disagreement = inputs.last_trip.disagreement;
  events.push(event);
}

}  // namespace

void EventReporter::report_overrun(std::uint32_t skipped, const ReportInputs& inputs,
                                   EventList& events) noexcept {
  unreported_overruns_ += started_ ? skipped : 0;
  started_ = true;
  if (unreported_overruns_ == 0 || inputs.tick - last_overrun_report_ < kReportEvery) return;
  report(EventType::kOverrun, inputs, events, unreported_overruns_);
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
  if (inputs.derating != reported_.derating) {
    report(inputs.derating ? EventType::kDeratingStarted : EventType::kDeratingEnded, inputs,
           events);
  }
  reported_ = {inputs.state, inputs.reason, inputs.attached, inputs.derating};
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

}  // namespace hedgehog::control
