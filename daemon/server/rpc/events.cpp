// SPDX-License-Identifier: MIT
// events.*
#include <memory>
#include <string>

#include "daemon/server/history/event_history.h"
#include "daemon/server/history/trip_recordings.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {

Outcome handle(Call& call, const protocol::EventsSubscribe& request) {
  call.session.events = {request.types, request.scope};
  const DeviceView& device_view = call.device_view();
  const control::StatusSnapshot& now = device_view.now();
  return Response(protocol::EventsResult{std::string(control::name(now.state)),
                                         device_view.reason_now(), now.derating,
                                         device_view.shown_limit_a(now.limit_a)});
}

Outcome handle(Call& call, const protocol::EventsUnsubscribe&) {
  call.session.events.reset();
  return Response(protocol::Done{});
}

Outcome handle(Call& call, const protocol::EventsHistory& request) {
  const TripRecordings* recordings = call.context.recordings;
  return Encoded{std::make_shared<const std::string>(call.context.history.newest(
      request,
      [recordings](unsigned number) { return recordings != nullptr && recordings->has(number); }))};
}

}  // namespace hedgehog::server
