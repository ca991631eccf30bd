// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/latency_verb.h"

#include <cstdio>
#include <optional>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

constexpr std::size_t kStageColumns = 24;
constexpr std::size_t kNumberColumns = 10;

std::string number(const std::string& text) { return ' ' + right(text, kNumberColumns - 1); }

std::string stage(const std::string& name,
                  const std::optional<protocol::LatencyQuantiles>& quantiles) {
  if (!quantiles) return left(name, kStageColumns) + number("-");
  std::string line = left(name, kStageColumns);
  for (const double us : {quantiles->p50, quantiles->p99, quantiles->max})
    line += number(fixed(us * 1e-3, 3));
  return line;
}

}  // namespace

std::vector<std::string> latency_lines(const protocol::LatencyResult& latency) {
  if (latency.effects == 0)
    return {"No effect has been played yet; play some, for example: hedgehogctl pulse left"};
  const std::string of = latency.effects == 1
                             ? "The newest effect"
                             : "The newest " + std::to_string(latency.effects) + " effects";
  return {of + ", milliseconds:",
          left("", kStageColumns) + number("p50") + number("p99") + number("max"),
          stage("read to queued", latency.received_to_queued_us),
          stage("queued to applied", latency.queued_to_applied_us),
          stage("applied to frame sent", latency.applied_to_written_us),
          stage("read to frame sent", latency.received_to_written_us)};
}

int run_latency(Session& session) {
  const auto text = session.connection.call_text(protocol::EffectLatency{});
  if (!text) return report_error(text.error());
  if (session.json) {
    std::puts(text->c_str());
    return kDone;
  }
  const auto latency = protocol::decode_result<protocol::LatencyResult>(*text);
  if (!latency) return report_error({Failure::kProtocol, latency.error().message, {}});
  for (const std::string& line : latency_lines(*latency)) std::puts(line.c_str());
  return kDone;
}

}  // namespace hedgehog::client
