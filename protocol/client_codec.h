// SPDX-License-Identifier: MIT
// A client's side of the wire: requests become lines, lines become answers and notifications.
// Fields, event types and reasons that are not known are ignored. Lines are without their LF.
// Nothing here throws or keeps anything; any thread.
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

/// `id` nullopt: carried out and never answered.
std::string encode_request(const std::optional<Id>& id, const Request& request);

/// A request whose `params` are given as a JSON object (empty: none), for programs that pass on
/// what a person typed.
std::string encode_raw_request(const std::optional<Id>& id, std::string_view method,
                               std::string_view params_json);

struct Reply {
  Id id{};
  /// The result as JSON text, compact, as the server ordered it; `decode_result` makes a value.
  Result<std::string> result;
};

/// A notification that is neither telemetry nor an event of ours is left out of its batch.
struct EventMessage {
  Event event{};
  std::string json{};  // the params as they came
};
struct TelemetryMessage {
  Telemetry telemetry{};
  std::string json{};
};
struct UnknownMessage {
  std::string method{};
};

using Message = std::variant<Reply, EventMessage, TelemetryMessage, UnknownMessage>;

/// One line from the server: one message, or the answers to a batch. An error when it is not
/// JSON-RPC at all.
Result<std::vector<Message>> decode_messages(std::string_view line);

/// The typed value of a result. Fields that the server left out keep their defaults; one of the
/// wrong type is an error naming it. T is one of the types of ResultValue.
template <class T>
Result<T> decode_result(std::string_view json);

/// Part of `decode_result`: lets `take` read what it knows of `json`; what is wrong with it.
std::optional<RpcError> read_result(std::string_view json,
                                    const std::function<void(Fields&)>& take);

template <class T>
Result<T> decode_result(std::string_view json) {
  T value{};
  if (auto wrong = read_result(json, [&](Fields& f) { f.value(value); })) return *std::move(wrong);
  return value;
}

}  // namespace hedgehog::protocol
