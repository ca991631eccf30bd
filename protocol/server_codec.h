// SPDX-License-Identifier: MIT
// The daemon's side of the wire: a line becomes requests, answers become lines. Lines are without
// their LF. Nothing here throws or keeps anything; any thread.
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
  /// nullopt: a notification, carried out and never answered, not even with an error.
  std::optional<Id> id{};
  /// Known also when its parameters are wrong; nullopt: no such method, or not a request.
  std::optional<Method> method{};
  Result<Request> request;
};

/// What one line holds. Not a batch: exactly one item. A batch: 1..64 items, to be carried out in
/// order within one tick.
struct Incoming {
  bool batch = false;
  std::vector<Item> items{};
};

/// Never fails: what cannot be understood is an item with the error to answer (id null). The 64 KiB
/// limit of a line is the caller's; `line_too_long` is its error.
Incoming decode_line(std::string_view line);
RpcError line_too_long();

std::string encode_result(const Id& id, const ResultValue& result);
/// The two halves of it, for an answer that is given again and again.
std::string encode_value(const ResultValue& result);
std::string encode_encoded(const Id& id, std::string_view value);
std::string encode_error(const Id& id, const RpcError& error);
/// The answers to a batch, as one line; empty when there is none to give (all were notifications).
std::string encode_batch(const std::vector<std::string>& answers);

/// Notifications to the client.
std::string encode_telemetry(const Telemetry& telemetry);
/// One line of an event history, without LF, and back; the error says what is wrong with it.
std::string encode_past_event(const PastEvent& event);
Result<PastEvent> decode_past_event(std::string_view json);
/// The result of events.history from such lines, oldest first.
std::string encode_history(const std::vector<std::string>& events, bool more);

std::string encode_event(const Event& event);

}  // namespace hedgehog::protocol
