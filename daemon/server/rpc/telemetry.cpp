// SPDX-License-Identifier: MIT
// telemetry.*
#include <algorithm>
#include <cmath>

#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {

Outcome handle(Call& call, const protocol::TelemetrySubscribe& request) {
  const double max_hz = call.device_view().config().telemetry_max_rate_hz;
  if (request.rate_hz > max_hz)
    return Response(protocol::out_of_range("rate_hz", max_hz, request.rate_hz));
  const auto period = static_cast<model::Tick>(std::lround(1000.0 / request.rate_hz));
  call.session.telemetry = {request.fields, std::max<model::Tick>(1, period),
                            call.device_view().now().tick};
  return Response(protocol::TelemetryResult{request.rate_hz, request.fields});
}

Outcome handle(Call& call, const protocol::TelemetryHistory& request) {
  const DeviceView& device_view = call.device_view();
  const model::Tick now = device_view.now().tick;
  return Response(call.context.telemetry.recent(request.seconds, now, device_view.time_ns(now)));
}

Outcome handle(Call& call, const protocol::TelemetryUnsubscribe&) {
  call.session.telemetry.reset();
  return Response(protocol::Done{});
}

}  // namespace hedgehog::server
