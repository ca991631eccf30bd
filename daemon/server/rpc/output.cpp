// SPDX-License-Identifier: MIT
// output.*
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {

Outcome handle(Call& call, const protocol::OutputSetGain& request) {
  const auto seq = call.device_view().request_gain(call.session.id, request.gain);
  if (!seq) return Response(queue_full(call.device_view().outbox()));
  call.context.state_store.persist_gain(request.gain);
  return Response(protocol::GainResult{request.gain, *seq});
}

}  // namespace hedgehog::server
