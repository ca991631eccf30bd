// SPDX-License-Identifier: MIT
// effect.latency
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {

Outcome handle(Call& call, const protocol::EffectLatency&) {
  const LatencyLog& latency = call.context.latency;
  const auto quantiles = [&](LatencyStage stage) -> std::optional<protocol::LatencyQuantiles> {
    if (latency.effects() == 0) return std::nullopt;
    const LatencyLog::Quantiles of_stage = latency.quantiles(stage);
    return protocol::LatencyQuantiles{of_stage.p50_us, of_stage.p99_us, of_stage.max_us};
  };
  return Response(protocol::LatencyResult{
      static_cast<std::int64_t>(latency.effects()), quantiles(LatencyStage::kReceivedToQueued),
      quantiles(LatencyStage::kQueuedToApplied), quantiles(LatencyStage::kAppliedToWritten),
      quantiles(LatencyStage::kReceivedToWritten)});
}

}  // namespace hedgehog::server
