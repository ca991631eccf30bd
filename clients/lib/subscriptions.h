// SPDX-License-Identifier: MIT
// What a program subscribed to, for the next connection.
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

/// Of one `Ball`, on its thread. The daemon keeps one subscription of each kind for a connection:
/// of several requests of a kind the one that was sent last holds, in whichever order responses
/// come.
class Subscriptions {
 public:
  /// What holds, to be made again.
  struct Held {
    std::uint64_t order = 0;  // of its request among all
    AnyRequest request;
  };

  /// A request that gets no response: it holds if this version of the protocol has it so, since a
  /// refusal is not answered. Other methods are ignored, here and below.
  void notified(const AnyRequest& request);
  /// A request that holds once `answered` has its acceptance.
  void asked(const protocol::Id& id, const AnyRequest& request);
  /// `one` of `current` was asked for again, on a new connection.
  void renewed(const protocol::Id& id, const Held& one);
  /// The method of a subscription that has ended by this response: the daemon refused to renew it.
  std::optional<std::string> answered(const protocol::Id& id, bool accepted);
  /// What was not answered before does not hold; a renewal stays due.
  void connection_lost() { pending_.clear(); }

  /// What holds, in the order in which it was subscribed to.
  const std::vector<Held>& current() const noexcept { return current_; }

 private:
  struct Pending {
    protocol::Id id;
    Held change;
    bool renewal = false;
  };
  void apply(const Held& change);

  std::uint64_t last_order_ = 0;
  std::map<std::string, std::uint64_t, std::less<>> applied_;  // by topic, the newest that holds
  std::vector<Held> current_;
  std::vector<Pending> pending_;
};

}  // namespace hedgehog::client
