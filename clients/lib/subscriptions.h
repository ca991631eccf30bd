// SPDX-License-Identifier: MIT
// Active subscriptions of a program, renewed on the next connection.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/methods.h"
#include "protocol/wire/id.h"

namespace hedgehog::client {

/// A method by name, with its parameters as JSON: an object or empty.
struct RawRequest {
  std::string method;
  std::string params_json;
};
using AnyRequest = std::variant<protocol::Request, RawRequest>;

/// Of one `Ball`, on its thread. The daemon keeps one subscription of each kind per connection: of
/// several requests of a kind the one sent last is in force, in whichever order responses arrive.
class Subscriptions {
 public:
  /// An active subscription, to be renewed.
  struct Held {
    std::uint64_t order = 0;  // number of its request
    AnyRequest request;
  };

  /// A request without a response: in force if this version of the protocol accepts it, since a
  /// refusal is not reported. Other methods are ignored, here and below.
  void on_notification(const AnyRequest& request);
  /// A request that is in force once `on_response` reports its acceptance.
  void on_request(const protocol::Id& id, const AnyRequest& request);
  /// `one` of `current` was requested again, on a new connection.
  void on_renewal(const protocol::Id& id, const Held& one);
  /// The method of a subscription that this response has ended: the daemon refused to renew it.
  std::optional<std::string> on_response(const protocol::Id& id, bool accepted);
  /// Requests without a response are discarded; renewals stay due.
  void on_connection_lost() { pending_.clear(); }

  /// The active subscriptions, in the order of their requests.
  const std::vector<Held>& current() const noexcept { return current_; }

 private:
  struct Pending {
    protocol::Id id;
    Held change;
    bool renewal = false;
  };
  void apply(const Held& change);

  std::uint64_t last_order_ = 0;
  std::map<std::string, std::uint64_t, std::less<>> applied_;  // by topic, the newest in force
  std::vector<Held> current_;
  std::vector<Pending> pending_;
};

}  // namespace hedgehog::client
