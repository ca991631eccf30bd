// SPDX-License-Identifier: MIT
// Active subscriptions of a program, renewed on the next connection.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/answer.h"

namespace hedgehog::unreal {

/// One thread. The daemon keeps one subscription of each kind per connection: of several requests
/// of a kind the one sent last is in force, in whichever order responses arrive.
class Subscriptions {
 public:
  struct Change {
    /// Number of its request, from 1.
    std::int64_t order = 0;
    std::string method{};
    Json params{};
    /// Requested again on a new connection.
    bool renewal = false;
  };

  /// A request whose response `answered` will report. 0: it does not concern a subscription.
  std::int64_t asked(const std::string& method, const Json& params);
  /// A request without a response: it is in force.
  void notified(const std::string& method, const Json& params);
  /// The requests to be repeated on a new connection; from now on these are renewals, except
  /// `queued`, whose responses the program waits for.
  std::vector<Change> renew(const std::vector<std::int64_t>& queued);
  /// The response to that change. True: the daemon has refused to renew a subscription, which has
  /// ended. Without a response of the daemon nothing changes.
  bool answered(std::int64_t order, const Answer& answer);

 private:
  std::int64_t last_order_ = 0;
  /// Changes that were not refused, of each kind the oldest first; the newest is or will be in
  /// force.
  std::vector<Change> changes_;
};

}  // namespace hedgehog::unreal
