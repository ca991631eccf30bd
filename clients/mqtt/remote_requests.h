// SPDX-License-Identifier: MIT
// Requests that come through the broker: from a message to a request of the daemon, and from its
// response to a message.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "clients/mqtt/message.h"
#include "clients/mqtt/topics.h"
#include "protocol/client_codec.h"

namespace hedgehog::mqtt {

struct RemoteRequest {
  std::string method{};
  std::string params_json{};  // an object, on one line
};

/// What `message` asks for, as far as it can be judged without the daemon. Errors: an unknown
/// method, a payload that is no JSON object; they are as the daemon's.
protocol::Result<RemoteRequest> remote_request(const Topics& topics, const Message& message);

/// A response for who asked: on the response topic of `request` the JSON-RPC object without its id,
/// {"result": ...} or {"error": ...}. Without that topic: an error goes to `refused` with the
/// request's topic, a result nowhere (no message).
std::vector<Message> response_to(const Topics& topics, const Message& request,
                                 const protocol::Result<std::string>& result);

/// Those that the daemon has not answered yet. One thread.
class PendingRequests {
 public:
  /// As many as a connection may have at the daemon.
  static constexpr std::size_t kMax = 64;

  bool full() const noexcept { return requests_.size() >= kMax; }
  void add(const protocol::Id& id, Message request) { requests_[id.json] = std::move(request); }
  /// What is to be published for the daemon's reply.
  std::vector<Message> take(const Topics& topics, const protocol::Reply& reply);
  /// The same for all: the daemon is gone.
  std::vector<Message> take_all(const Topics& topics);

 private:
  std::map<std::string, Message> requests_;  // by the id's JSON text
};

}  // namespace hedgehog::mqtt
