// SPDX-License-Identifier: MIT
// Back-off of addresses with wrong tokens; bounds the processor time and log lines of attempts.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "model/tick.h"

namespace hedgehog::server {

/// io thread only. Times are those of the caller, in ticks.
class FailedTokens {
 public:
  static constexpr int kFree = 3;                   // failures without a wait, for mistyped tokens
  static constexpr model::Tick kFirstWait = 1'000;  // after each further failure; doubled each time
  static constexpr model::Tick kMaxWait = 60'000;
  static constexpr model::Tick kMemory = 600'000;    // an entry expires after it without a failure
  static constexpr std::size_t kMaxAddresses = 256;  // beyond it the oldest failure is removed

  /// The host of "192.0.2.7:5000" or "[2001:db8::1]:5000"; of IPv6 the first 64 bits, its network.
  static std::string key_of(std::string_view address);

  /// Remaining wait of `key`; 0: may try.
  model::Tick remaining(const std::string& key, model::Tick now) const;
  void failed(const std::string& key, model::Tick now);            // sent a wrong token
  void succeeded(const std::string& key) { entries_.erase(key); }  // sent a valid token
  std::size_t size() const noexcept { return entries_.size(); }

 private:
  struct Entry {
    int failures = 0;
    model::Tick last = 0;
    model::Tick until = 0;
  };
  void make_space(model::Tick now);

  std::map<std::string, Entry> entries_;
};

}  // namespace hedgehog::server
