// SPDX-License-Identifier: MIT
// Server-side codec: lines to requests, responses to lines. Lines are without LF. Stateless, does
// not throw; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/methods.h"
#include "protocol/values/event.h"
#include "protocol/wire/error.h"
#include "protocol/wire/id.h"

namespace hedgehog::protocol {

inline constexpr std::size_t kMaxLineBytes = 65'536;
inline constexpr std::size_t kMaxBatch = 64;
inline constexpr std::size_t kMaxNesting = 32;

struct Item {
  /// nullopt: a notification, executed without a response, not even an error.
  std::optional<Id> id{};
  /// Set even if the parameters are invalid; nullopt: unknown method, or not a request.
  std::optional<Method> method{};
  Result<Request> request;
};

/// Content of one line. Not a batch: exactly one item. Batch: 1..64 items, to be executed in order
/// within one tick.
struct Incoming {
  bool batch = false;
  std::vector<Item> items{};
};

/// Never fails: invalid input becomes an item with an error (id null). The caller enforces the 64
/// KiB limit of a line with the error `line_too_long`.
Incoming decode_line(std::string_view line);
RpcError line_too_long();

std::string encode_result(const Id& id, const ResultValue& result);
/// The two steps of `encode_result`, for a result that is sent repeatedly.
std::string encode_value(const ResultValue& result);
std::string encode_encoded(const Id& id, std::string_view value);
std::string encode_error(const Id& id, const RpcError& error);
/// The responses to a batch as one line; empty if there are none (only notifications).
std::string encode_batch(const std::vector<std::string>& responses);

/// Notifications to the client.
std::string encode_telemetry(const Telemetry& telemetry);
/// One line of an event history, without LF, and its inverse; the error describes the problem.
std::string encode_past_event(const PastEvent& event);
Result<PastEvent> decode_past_event(std::string_view json);
/// The result of events.history from such lines, oldest first.
std::string encode_history(const std::vector<std::string>& events, bool more);

std::string encode_event(const Event& event);

}  // namespace hedgehog::protocol
