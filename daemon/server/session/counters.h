// SPDX-License-Identifier: MIT
// Counters of the server since its start, for the metrics. Keys are names with static lifetime
// (methods, reasons), never a client's text, so there are few of them.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

namespace hedgehog::server {

/// io thread only.
struct Counters {
  using Name = std::string_view;
  /// By method ("none" when it was not even a request) and error code, 0 = ok.
  std::map<std::pair<Name, int>, std::uint64_t> requests;
  /// By method and how it ended; "refused": never started.
  std::map<std::pair<Name, Name>, std::uint64_t> effects;
  /// Effects that were admitted with less than asked, by why; of those whose answer was read.
  std::map<Name, std::uint64_t> limited;
  /// Clients turned away or cut off, by why.
  std::map<Name, std::uint64_t> rejected;
  /// By reason.
  std::map<Name, std::uint64_t> trips;
  std::uint64_t telemetry_dropped = 0;
};

}  // namespace hedgehog::server
