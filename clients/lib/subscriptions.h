// SPDX-License-Identifier: MIT
// What a program subscribed to, for the next connection.
#pragma once

#include <string>
#include <utility>
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

/// Of one `Ball`, on its thread. The daemon keeps one subscription of each kind for a connection.
class Subscriptions {
 public:
  /// A request that gets no response: it holds. Other methods are ignored, here and below.
  void notified(const AnyRequest& request);
  /// A request that holds once `answered` has its acceptance.
  void asked(const protocol::Id& id, const AnyRequest& request);
  void answered(const protocol::Id& id, bool accepted);
  /// What was not answered before does not hold.
  void connection_lost() { pending_.clear(); }

  /// What holds, in the order in which it was subscribed to.
  const std::vector<AnyRequest>& current() const noexcept { return current_; }

 private:
  std::vector<AnyRequest> current_;
  std::vector<std::pair<protocol::Id, AnyRequest>> pending_;
};

}  // namespace hedgehog::client
