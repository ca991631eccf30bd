// SPDX-License-Identifier: MIT
// Back-off of addresses that send wrong tokens. A token cannot be guessed; this bounds the
// processor time and the log lines of the attempts.
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
  /// Number of failures without a wait, for mistyped tokens.
  static constexpr int kFree = 3;
  /// Wait after each further failure; doubled each time.
  static constexpr model::Tick kFirstWait = 1'000;
  static constexpr model::Tick kMaxWait = 60'000;
  /// An entry expires after this time without a failure.
  static constexpr model::Tick kMemory = 600'000;
  /// Beyond this the entry with the oldest failure is removed.
  static constexpr std::size_t kMaxAddresses = 256;

  /// Key for "192.0.2.7:5000" or "[2001:db8::1]:5000": the host; of IPv6 the first 64 bits, since a
  /// network has any number of addresses.
  static std::string key_of(std::string_view address);

  /// Remaining wait of `key`; 0: may try.
  model::Tick remaining(const std::string& key, model::Tick now) const;
  /// `key` has sent a wrong token.
  void failed(const std::string& key, model::Tick now);
  /// `key` has sent a valid token.
  void succeeded(const std::string& key) { entries_.erase(key); }
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
