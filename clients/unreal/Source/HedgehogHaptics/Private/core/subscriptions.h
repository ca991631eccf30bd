// SPDX-License-Identifier: MIT
// What a program subscribed to, for the next connection.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/answer.h"

namespace hedgehog::unreal {

/// One thread. The daemon keeps one subscription of each kind for a connection: of several requests
/// of a kind the one that was sent last holds, in whichever order they are answered.
class Subscriptions {
 public:
  struct Change {
    /// Of its request among all, from 1.
    std::int64_t order = 0;
    std::string method{};
    Json params{};
    /// Asked for again on a new connection.
    bool renewal = false;
  };

  /// A request that `answered` will be told of. 0: it is about no subscription.
  std::int64_t asked(const std::string& method, const Json& params);
  /// A request that is not answered: it holds.
  void notified(const std::string& method, const Json& params);
  /// What a new connection has to ask for; from now on these are renewals, except `queued`, which
  /// the program waits for.
  std::vector<Change> renew(const std::vector<std::int64_t>& queued);
  /// The daemon's answer to that change. True: it has refused to renew a subscription, which has
  /// ended. Without an answer of the daemon nothing changes.
  bool answered(std::int64_t order, const Answer& answer);

 private:
  std::int64_t last_order_ = 0;
  /// The changes that were not refused, of each kind the oldest first; the newest holds, or will.
  std::vector<Change> changes_;
};

}  // namespace hedgehog::unreal
