// SPDX-License-Identifier: MIT
#include "protocol/server_codec.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "protocol/methods.h"
#include "protocol/wire/json.h"
#include "protocol/wire/plain_json.h"
#include "protocol/wire/reader.h"
#include "protocol/wire/writer.h"

namespace hedgehog::protocol {
namespace {

RpcError invalid_request(std::string what) {
  return error(ErrorCode::kInvalidRequest, "invalid_request: " + std::move(what));
}

/// 2^53: up to here a double represents every integer, so that an id survives any client's JSON
/// parser.
constexpr std::int64_t kMaxId = 9'007'199'254'740'992;

/// The id if valid: a string, a number of at most kMaxId, or null.
std::optional<Id> read_id(const Json& json) {
  const auto* whole = json.as<std::int64_t>();
  const auto* number = json.as<double>();
  const bool good = whole != nullptr ? *whole >= -kMaxId && *whole <= kMaxId
                    : number != nullptr
                        ? std::fabs(*number) <= static_cast<double>(kMaxId)
                        : json.as<std::nullptr_t>() != nullptr || json.as<std::string>() != nullptr;
  return good ? std::optional(Id{to_text(json)}) : std::nullopt;
}

RpcError no_such_method(std::string_view method) {
  std::vector<std::string_view> names;
  names.reserve(kMethods.size());
  for (const MethodInfo& row : kMethods) names.push_back(row.name);
  const std::string shown = shortened(method);
  RpcError made = error(ErrorCode::kMethodNotFound, "method_not_found: there is no method '" +
                                                        shown + "'" + hint(method, names));
  made.field = "method";
  made.value = shown;
  return made;
}

Result<Request> read_params(Method method, const Json* params) {
  static const Json kNone{Json::Object{}};
  if (params != nullptr && params->as<Json::Object>() == nullptr) {
    return invalid_params(
        "params", "must be an object with parameters by name, not " + std::string(params->kind()));
  }
  Request request = empty_request(method);
  const bool has_none = std::visit([]<class R>(const R&) { return std::is_empty_v<R>; }, request);
  if (params == nullptr && has_none) return request;
  Reader reader(params == nullptr ? kNone : *params, Reader::Strictness::kStrict, name(method));
  std::visit([&](auto& one) { reader.value(one); }, request);
  if (reader.error()) return *reader.error();
  return request;
}

Item refused(std::optional<Id> id, RpcError error) {
  return {std::move(id), std::nullopt, std::move(error)};
}

/// The members of a request, before they are checked. nullopt, nullptr: missing, or not a string.
struct Envelope {
  std::optional<std::string_view> version;
  std::optional<std::string_view> method;
  const Json* id = nullptr;
  const Json* params = nullptr;
};

Item read_item(const Envelope& envelope) {
  std::optional<Id> id;
  if (envelope.id != nullptr) {
    id = read_id(*envelope.id);
    if (!id)
      return refused(Id{},
                     invalid_request("id must be a string, a number of at most 2^53, or null"));
  }
  // An item not recognised as a notification gets a response (JSON-RPC 2.0, section 5).
  const auto refuse = [&](RpcError error) { return refused(id.value_or(Id{}), std::move(error)); };
  if (envelope.version != "2.0") return refuse(invalid_request("\"jsonrpc\":\"2.0\" is missing"));
  if (!envelope.method) return refuse(invalid_request("method is missing or not a string"));
  const std::optional<Method> method = method_named(*envelope.method);
  if (!method) return refused(std::move(id), no_such_method(*envelope.method));
  return {std::move(id), method, read_params(*method, envelope.params)};
}

std::optional<std::string_view> text_of(const Json* json) noexcept {
  const auto* text = json == nullptr ? nullptr : json->as<std::string>();
  return text == nullptr ? std::nullopt : std::optional<std::string_view>(*text);
}

Item read_item(const Json& json) {
  if (json.as<Json::Object>() == nullptr) {
    return refused(Id{},
                   invalid_request("a request is an object, not " + std::string(json.kind())));
  }
  return read_item(Envelope{text_of(json.find("jsonrpc")), text_of(json.find("method")),
                            json.find("id"), json.find("params")});
}

Item read_item(const PlainRequest& request) {
  return read_item(Envelope{request.version, request.method, request.id ? &*request.id : nullptr,
                            request.params ? &*request.params : nullptr});
}

void append_value(std::string& out, const ErrorValue& value) {
  std::visit([&](const auto& v) { append(out, v); }, value);
}

void append_data(std::string& out, const RpcError& error) {
  out += "{\"name\":";
  append_string(out, name(error.code));
  const auto field = [&](std::string_view key, const auto& value) {
    if (value) {
      out += ",\"";
      out += key;
      out += "\":";
      append(out, *value);
    }
  };
  const auto scalar = [&](std::string_view key, const std::optional<ErrorValue>& value) {
    if (value) {
      out += ",\"";
      out += key;
      out += "\":";
      append_value(out, *value);
    }
  };
  field("field", error.field);
  scalar("limit", error.limit);
  scalar("value", error.value);
  field("state", error.state);
  field("reason", error.reason);
  field("remedy", error.remedy);
  field("role_needed", error.role_needed);
  field("retry_after_ms", error.retry_after_ms);
  field("device", error.device);
  field("limit_a", error.limit_a);
  out += '}';
}

template <class T>
std::string notification(std::string_view method, const T& params) {
  std::string out = "{\"jsonrpc\":\"2.0\",\"method\":";
  append_string(out, method);
  out += ",\"params\":";
  append(out, params);
  out += '}';
  return out;
}

std::string joined(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) {
    out += out.empty() ? "" : ",";
    out += value;
  }
  return out;
}

/// Beginning of a response; reserves the usual size.
std::string answer(const Id& id) {
  constexpr std::size_t kUsualBytes = 240;
  std::string out;
  out.reserve(kUsualBytes);
  out += R"({"jsonrpc":"2.0","id":)";
  out += id.json;
  return out;
}

void append_result(std::string& out, const ResultValue& result) {
  if (const auto* hello = std::get_if<HelloResult>(&result); hello && hello->methods.empty()) {
    HelloResult filled = *hello;
    for (const MethodInfo& row : kMethods) filled.methods.emplace_back(row.name);
    append(out, filled);
  } else {
    std::visit([&](const auto& value) { append(out, value); }, result);
  }
}

}  // namespace

RpcError line_too_long() {
  RpcError made = error(ErrorCode::kParseError, "parse_error: the line is longer than " +
                                                    std::to_string(kMaxLineBytes) + " bytes");
  made.limit = static_cast<std::int64_t>(kMaxLineBytes);
  return made;
}

Incoming decode_line(std::string_view line) {
  Incoming incoming;
  if (const auto request = parse_plain_request(line, kMaxNesting)) {
    incoming.items.push_back(read_item(*request));
    return incoming;
  }
  const Result<Json> parsed = parse_json(line, kMaxNesting);
  if (!parsed) {
    incoming.items.push_back(refused(Id{}, parsed.error()));
    return incoming;
  }
  const auto* batch = parsed->as<Json::List>();
  if (batch == nullptr) {
    incoming.items.push_back(read_item(*parsed));
  } else if (batch->empty()) {
    incoming.items.push_back(refused(Id{}, invalid_request("the batch is empty")));
  } else if (batch->size() > kMaxBatch) {
    RpcError error = invalid_request("the batch has " + std::to_string(batch->size()) +
                                     " requests, more than " + std::to_string(kMaxBatch));
    error.limit = static_cast<std::int64_t>(kMaxBatch);
    error.value = static_cast<std::int64_t>(batch->size());
    incoming.items.push_back(refused(Id{}, std::move(error)));
  } else {
    incoming.batch = true;
    incoming.items.reserve(batch->size());
    for (const Json& item : *batch) incoming.items.push_back(read_item(item));
  }
  return incoming;
}

std::string encode_result(const Id& id, const ResultValue& result) {
  std::string out = answer(id);
  out += ",\"result\":";
  append_result(out, result);
  out += '}';
  return out;
}

std::string encode_encoded(const Id& id, std::string_view value) {
  std::string out = answer(id);
  out += ",\"result\":";
  out += value;
  out += '}';
  return out;
}

std::string encode_value(const ResultValue& result) {
  std::string out;
  append_result(out, result);
  return out;
}

std::string encode_error(const Id& id, const RpcError& error) {
  std::string out = answer(id);
  out += ",\"error\":{\"code\":";
  out += std::to_string(static_cast<int>(error.code));
  out += ",\"message\":";
  append_string(out, error.message);
  out += ",\"data\":";
  append_data(out, error);
  out += "}}";
  return out;
}

std::string encode_batch(const std::vector<std::string>& responses) {
  return responses.empty() ? std::string() : '[' + joined(responses) + ']';
}

std::string encode_history(const std::vector<std::string>& events, bool more) {
  return R"({"events":[)" + joined(events) + R"(],"more":)" + (more ? "true}" : "false}");
}

std::string encode_telemetry(const Telemetry& telemetry) {
  return notification("telemetry", telemetry);
}

std::string encode_past_event(const PastEvent& event) {
  std::string out;
  append(out, event);
  return out;
}

Result<PastEvent> decode_past_event(std::string_view json) {
  const Result<Json> parsed = parse_json(json, kMaxNesting);
  if (!parsed) return parsed.error();
  PastEvent event;
  Reader reader(*parsed, Reader::Strictness::kLenient, "an event");
  reader.value(event);
  if (reader.error()) return *reader.error();
  return event;
}

std::string encode_event(const Event& event) { return notification("event", event); }

}  // namespace hedgehog::protocol
