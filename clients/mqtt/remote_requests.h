// SPDX-License-Identifier: MIT
// Requests from the broker: conversion of messages to requests of the daemon, and of responses to
// messages.
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

/// The request in `message`, checked as far as possible without the daemon. Errors: an unknown
/// method, a payload that is not a JSON object; same errors as the daemon's.
protocol::Result<RemoteRequest> remote_request(const Topics& topics, const Message& message);

/// The response to the requesting client: on the response topic of `request` the JSON-RPC object
/// without its id, {"result": ...} or {"error": ...}. Without that topic: an error is published on
/// `refused` with the request's topic, a result is not published.
std::vector<Message> response_to(const Topics& topics, const Message& request,
                                 const protocol::Result<std::string>& result);

/// Requests without a response so far. One thread.
class PendingRequests {
 public:
  /// Limit of pending requests of one connection at the daemon.
  static constexpr std::size_t kMax = 64;

  bool full() const noexcept { return requests_.size() >= kMax; }
  void add(const protocol::Id& id, Message request) { requests_[id.json] = std::move(request); }
  /// Messages to be published for the daemon's reply.
  std::vector<Message> take(const Topics& topics, const protocol::Reply& reply);
  /// The same for all, with an error: the connection is lost.
  std::vector<Message> take_all(const Topics& topics);

 private:
  std::map<std::string, Message> requests_;  // by the id's JSON text
};

}  // namespace hedgehog::mqtt
