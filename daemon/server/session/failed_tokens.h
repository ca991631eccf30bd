// SPDX-License-Identifier: MIT
// Back-off of addresses that show wrong tokens. A token cannot be guessed; this bounds what the
// attempts cost, in processor time and in lines of the log.
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
  /// So many failures cost nothing: a person mistypes.
  static constexpr int kFree = 3;
  /// After each further one the address waits, first so long, then twice as long each time.
  static constexpr model::Tick kFirstWait = 1'000;
  static constexpr model::Tick kMaxWait = 60'000;
  /// Without a failure for so long it is forgotten.
  static constexpr model::Tick kMemory = 600'000;
  /// Beyond it, the address whose last failure is oldest is forgotten.
  static constexpr std::size_t kMaxAddresses = 256;

  /// What is counted of "192.0.2.7:5000" or "[2001:db8::1]:5000": the host; of IPv6 the first 64
  /// bits, since a network has as many addresses as it likes.
  static std::string key_of(std::string_view address);

  /// How long `key` still has to wait; 0: it may try.
  model::Tick remaining(const std::string& key, model::Tick now) const;
  /// It has shown a wrong token.
  void failed(const std::string& key, model::Tick now);
  /// It has shown a good one.
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
