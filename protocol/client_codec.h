// SPDX-License-Identifier: MIT
// Client-side codec: requests to lines, lines to responses and notifications. Unknown fields, event
// types and reasons are ignored. Lines are without LF. Stateless, does not throw; any thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/methods.h"
#include "protocol/values/event.h"
#include "protocol/wire/error.h"
#include "protocol/wire/id.h"

namespace hedgehog::protocol {

/// `id` nullopt: a notification, which has no response.
std::string encode_request(const std::optional<Id>& id, const Request& request);

/// A request with `params` as JSON text of an object (empty: none), for programs that forward user
/// input.
std::string encode_raw_request(const std::optional<Id>& id, std::string_view method,
                               std::string_view params_json);

struct Reply {
  Id id{};
  /// The result as compact JSON text in the server's order; decoded by `decode_result`.
  Result<std::string> result;
};

/// Notification with method "event".
struct EventMessage {
  Event event{};
  std::string json{};  // the params as received
};
struct TelemetryMessage {
  Telemetry telemetry{};
  std::string json{};
};
struct UnknownMessage {
  std::string method{};
};

using Message = std::variant<Reply, EventMessage, TelemetryMessage, UnknownMessage>;

/// Decodes one line from the server: one message, or the responses to a batch. An error if it is
/// not JSON-RPC.
Result<std::vector<Message>> decode_messages(std::string_view line);

/// The typed value of a result. Missing fields keep their defaults; a field of the wrong type is an
/// error naming it. T is one of the types of ResultValue.
template <class T>
Result<T> decode_result(std::string_view json);

/// Part of `decode_result`: reads the known fields of `json` with `take`; returns the error, if
/// any.
std::optional<RpcError> read_result(std::string_view json,
                                    const std::function<void(Fields&)>& take);

template <class T>
Result<T> decode_result(std::string_view json) {
  T value{};
  if (auto wrong = read_result(json, [&](Fields& f) { f.value(value); })) return *std::move(wrong);
  return value;
}

}  // namespace hedgehog::protocol
