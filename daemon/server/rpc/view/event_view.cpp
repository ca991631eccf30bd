// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/view/event_view.h"

#include <cmath>
#include <string>

#include "model/tick.h"

namespace hedgehog::server {
namespace {

using control::EventType;

std::int64_t time_ns(model::Tick tick, std::int64_t epoch_ns) {
  return epoch_ns + tick * model::kNanosecondsPerTick;
}

void fill_end(protocol::Event& out, const control::Event& event, std::int64_t epoch_ns) {
  const control::Delivery& d = event.delivery;
  out.reason = std::string(control::name(event.end_reason));
  if (d.onset >= 0) {
    out.onset_ns = time_ns(d.onset, epoch_ns);
    out.offset_ns = time_ns(d.offset, epoch_ns);
  }
  out.delivered = protocol::EventDelivery{d.min, d.mean};
  out.masked_ms = d.masked;
  out.mixed_ms = d.mixed;
}

// The snapshot of `facts` may be older than a trip.
RemedyFacts facts_of(const control::Event& event, RemedyFacts facts) {
  if (event.trip) facts.contradicted = event.disagreement.any();
  return facts;
}

}  // namespace

std::optional<protocol::Disagreement> disagreement_view(const control::Disagreement& found) {
  if (!found.any()) return std::nullopt;
  protocol::Disagreement out;
  out.coil = found.coil();
  for (int i = 0; i < control::kQuantities; ++i) {
    const auto quantity = static_cast<control::Quantity>(i);
    if (found.has(quantity)) out.between.emplace_back(name(quantity));
  }
  return out;
}

std::optional<protocol::Event> event_view(const control::Event& event, const Effect* effect,
                                          std::int64_t epoch_ns, const RemedyFacts& facts) {
  protocol::Event out;
  out.type = std::string(control::name(event.type));
  out.time_ns = time_ns(event.tick, epoch_ns);
  switch (event.type) {
    case EventType::kEffectStarted:
    case EventType::kEffectEnded:
      out.effect = event.effect;
      if (effect != nullptr) out.slot = effect->slot;
      if (event.type == EventType::kEffectStarted)
        out.seq = event.seq;
      else
        fill_end(out, event, epoch_ns);
      return out;
    case EventType::kStateChanged:
      out.state = std::string(control::name(event.state));
      out.reason = reason_name(event.reason);
      out.remedy = remedy(event.state, event.reason, facts_of(event, facts));
      if (event.trip) {
        out.current_a = event.current_a;
        if (std::isfinite(event.temperature_c)) out.temperature_c = event.temperature_c;
        out.disagreement = disagreement_view(event.disagreement);
      }
      return out;
    case EventType::kDeratingStarted:
    case EventType::kDeratingEnded:
      out.limit_a = event.limit_a;
      if (std::isfinite(event.temperature_c)) out.temperature_c = event.temperature_c;
      return out;
    case EventType::kDeviceAttached:
    case EventType::kDeviceDetached:
      out.device = "board";
      if (event.type == EventType::kDeviceDetached) out.reason = reason_name(event.reason);
      return out;
    case EventType::kOverrun:
      out.skipped = event.count;
      return out;
    case EventType::kMeasurementRejected:
    case EventType::kMeasurementAccepted:
      out.disagreement = disagreement_view(event.disagreement);
      return out;
    case EventType::kOrientationLost:
    case EventType::kOrientationRestored:
      return out;
    case EventType::kRejectedNumber:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace hedgehog::server
