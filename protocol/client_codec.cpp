// SPDX-License-Identifier: MIT
#include "protocol/client_codec.h"

#include <utility>

#include "protocol/wire/json.h"
#include "protocol/wire/reader.h"
#include "protocol/wire/writer.h"

namespace hedgehog::protocol {
namespace {

RpcError not_understood(std::string what) {
  return error(ErrorCode::kParseError, "the server's answer cannot be read: " + std::move(what));
}

std::string opening(const std::optional<Id>& id, std::string_view method) {
  std::string out = "{\"jsonrpc\":\"2.0\"";
  if (id) out += ",\"id\":" + id->json;
  out += ",\"method\":";
  append_string(out, method);
  return out;
}

/// Reads the known fields of `json` with `take`; returns the error, if any.
std::optional<RpcError> read(const Json& json, std::string_view what,
                             const std::function<void(Fields&)>& take) {
  Reader reader(json, Reader::Strictness::kLenient, what);
  take(reader);
  if (reader.error()) return not_understood(reader.error()->message);
  return std::nullopt;
}

std::optional<ErrorValue> as_value(const Json* json) {
  if (json == nullptr) return std::nullopt;
  if (const auto* flag = json->as<bool>()) return *flag;
  if (const auto* integer = json->as<std::int64_t>()) return *integer;
  if (const auto* number = json->as<double>()) return *number;
  if (const auto* text = json->as<std::string>()) return *text;
  return std::nullopt;
}

template <class T>
std::optional<T> member(const Json& json, std::string_view name) {
  const Json* found = json.find(name);
  const T* value = found == nullptr ? nullptr : found->as<T>();
  return value == nullptr ? std::nullopt : std::optional<T>(*value);
}

RpcError read_error(const Json& json) {
  RpcError made;
  made.code = static_cast<ErrorCode>(
      member<std::int64_t>(json, "code").value_or(static_cast<int>(ErrorCode::kInternalError)));
  made.message = member<std::string>(json, "message").value_or("the server gave no reason");
  const Json* data = json.find("data");
  if (data == nullptr) return made;
  made.field = member<std::string>(*data, "field");
  made.limit = as_value(data->find("limit"));
  made.value = as_value(data->find("value"));
  made.state = member<std::string>(*data, "state");
  made.reason = member<std::string>(*data, "reason");
  made.remedy = member<std::string>(*data, "remedy");
  made.role_needed = role_named(member<std::string>(*data, "role_needed").value_or(""));
  made.retry_after_ms = member<std::int64_t>(*data, "retry_after_ms");
  made.device = member<std::string>(*data, "device");
  if (const Json* limit = data->find("limit_a")) {
    const auto* integer = limit->as<std::int64_t>();
    made.limit_a = integer == nullptr ? member<double>(*data, "limit_a")
                                      : std::optional<double>(static_cast<double>(*integer));
  }
  return made;
}

Result<Message> read_notification(const std::string& method, const Json* params) {
  static const Json kNone{Json::Object{}};
  const Json& json = params == nullptr ? kNone : *params;
  if (method == "event") {
    EventMessage message;
    message.json = to_text(json);
    const auto wrong = read(json, "the event", [&](Fields& f) { f.value(message.event); });
    return wrong ? Result<Message>(*wrong) : Message{std::move(message)};
  }
  if (method == "telemetry") {
    TelemetryMessage message;
    message.json = to_text(json);
    const auto wrong = read(json, "the telemetry", [&](Fields& f) { f.value(message.telemetry); });
    return wrong ? Result<Message>(*wrong) : Message{std::move(message)};
  }
  return Message{UnknownMessage{method}};
}

Result<Message> read_message(const Json& json) {
  if (json.as<Json::Object>() == nullptr)
    return not_understood("a message is an object, not " + std::string(json.kind()));
  if (const auto method = member<std::string>(json, "method"))
    return read_notification(*method, json.find("params"));
  const Json* id = json.find("id");
  Id answered{id == nullptr ? "null" : to_text(*id)};
  if (const Json* failed = json.find("error"))
    return Message{Reply{std::move(answered), read_error(*failed)}};
  if (const Json* result = json.find("result"))
    return Message{Reply{std::move(answered), to_text(*result)}};
  return not_understood("it has neither method nor result nor error");
}

}  // namespace

std::string encode_request(const std::optional<Id>& id, const Request& request) {
  std::string out = opening(id, name(method_of(request)));
  std::string params;
  std::visit([&](const auto& value) { append(params, value); }, request);
  if (params != "{}") out += ",\"params\":" + params;
  out += '}';
  return out;
}

std::string encode_raw_request(const std::optional<Id>& id, std::string_view method,
                               std::string_view params_json) {
  std::string out = opening(id, method);
  if (!params_json.empty()) {
    out += ",\"params\":";
    out += params_json;
  }
  out += '}';
  return out;
}

Result<std::vector<Message>> decode_messages(std::string_view line) {
  constexpr std::size_t kNesting = 64;
  const Result<Json> parsed = parse_json(line, kNesting);
  if (!parsed) return not_understood(parsed.error().message);
  std::vector<Message> messages;
  const auto* batch = parsed->as<Json::List>();
  for (const Json& json : batch == nullptr ? std::span(&*parsed, 1) : std::span(*batch)) {
    Result<Message> message = read_message(json);
    if (!message) return message.error();
    messages.push_back(std::move(*message));
  }
  return messages;
}

std::optional<RpcError> read_result(std::string_view json,
                                    const std::function<void(Fields&)>& take) {
  constexpr std::size_t kNesting = 64;
  const Result<Json> parsed = parse_json(json, kNesting);
  if (!parsed) return not_understood(parsed.error().message);
  return read(*parsed, "the result", take);
}

}  // namespace hedgehog::protocol
