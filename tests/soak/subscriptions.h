// SPDX-License-Identifier: MIT
// The notifications that one connection may receive, derived from its requests and their responses.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "protocol/server_codec.h"
#include "protocol/wire/json.h"
#include "tests/soak/pending_responses.h"

namespace hedgehog::soak {

class Subscriptions {
 public:
  void sent(const protocol::Incoming& incoming);
  void on_response(const CompletedRequest& completed);
  /// Throws Failure when no subscription covers it.
  void notified(const protocol::Json& message);

 private:
  /// Telemetry: names of the fields; events: the types; an empty set: all.
  struct Stream {
    /// nullopt: no subscription.
    std::optional<std::set<std::string>> names;
    /// A request without a response of its own may have changed it.
    bool uncertain = false;
    int uncertain_sent = 0;
  };
  struct Request {
    bool telemetry = false;
    std::optional<std::set<std::string>> names;
    int uncertain_sent = 0;
  };

  std::map<std::string, Request> requests_;  // by the id's JSON text
  Stream telemetry_;
  Stream events_;
  std::int64_t last_time_ns_ = 0;
};

}  // namespace hedgehog::soak
