// SPDX-License-Identifier: MIT
// The pending responses of one connection: each request with an id gets one, with its method's
// schema or with an error that its method lists.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/server_codec.h"
#include "protocol/wire/json.h"

namespace hedgehog::soak {

/// An expected response that has arrived, with its request's method if there is one.
struct CompletedRequest {
  std::string id;
  std::optional<protocol::Method> method;
  const protocol::Json* result = nullptr;  // null: an error
  int error = 0;                           // 0: a result
};

class PendingResponses {
 public:
  using OnResponse = std::function<void(const CompletedRequest&)>;

  /// Registers the expected response to a sent line, as decoded by the protocol's decoder.
  void expect(const protocol::Incoming& incoming);
  /// Registers the response to a line of more than 64 KiB.
  void expect_parse_error();
  /// Matches a response or a batch of responses. Throws Failure when none or another one was
  /// expected.
  void receive(const protocol::Json& message, const OnResponse& on_response);

  std::size_t size() const noexcept { return size_; }
  /// Some of the missing responses, for a report.
  std::string text() const;

 private:
  struct Expected {
    std::string id;
    std::optional<protocol::Method> method;
    std::optional<int> error;  // the request can only be rejected, with this code
  };
  using Batch = std::vector<Expected>;

  void receive_one(const protocol::Json& message, const OnResponse& on_response);
  void receive_batch(const protocol::Json::List& messages, const OnResponse& on_response);

  std::map<std::string, std::list<Expected>> single_;  // by the id's JSON text
  std::list<Batch> batches_;
  std::size_t size_ = 0;
};

}  // namespace hedgehog::soak
