// SPDX-License-Identifier: MIT
// Counters of the server since its start, for the metrics. Keys are names with static lifetime
// (methods, reasons), never a client's text, so that their number is bounded.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "daemon/server/session/request_counts.h"

namespace hedgehog::server {

/// io thread only.
struct Counters {
  using Name = std::string_view;
  RequestCounts requests;
  /// By method and end reason; "refused": never started.
  std::map<std::pair<Name, Name>, std::uint64_t> effects;
  /// Effects admitted with less than requested, by cause; only requests with a response.
  std::map<Name, std::uint64_t> limited;
  std::map<Name, std::uint64_t> rejected;  // clients rejected or disconnected, by reason
  std::map<Name, std::uint64_t> trips;     // by reason
  std::uint64_t telemetry_dropped = 0;
};

}  // namespace hedgehog::server
