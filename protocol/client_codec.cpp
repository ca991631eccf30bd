// SPDX-License-Identifier: MIT
#include "protocol/client_codec.h"

#include "protocol/describe.h"
#include "protocol/json.h"
#include "protocol/reader.h"
#include "protocol/writer.h"

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

/// A value described from JSON, leniently.
template <class T>
Result<T> read(const Json& json, std::string_view what) {
  T value{};
  Reader reader(json, Reader::Strictness::kLenient, what);
  reader.value(value);
  if (reader.error()) return not_understood(reader.error()->message);
  return value;
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
    Result<Event> event = read<Event>(json, "the event");
    return event ? Result<Message>(EventMessage{*event, to_text(json)}) : event.error();
  }
  if (method == "telemetry") {
    Result<Telemetry> telemetry = read<Telemetry>(json, "the telemetry");
    return telemetry ? Result<Message>(TelemetryMessage{*telemetry, to_text(json)})
                     : telemetry.error();
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
  const Json::List single = batch == nullptr ? Json::List{*parsed} : Json::List{};
  for (const Json& json : batch == nullptr ? single : *batch) {
    Result<Message> message = read_message(json);
    if (!message) return message.error();
    messages.push_back(std::move(*message));
  }
  return messages;
}

template <class T>
Result<T> decode_result(std::string_view json) {
  constexpr std::size_t kNesting = 64;
  const Result<Json> parsed = parse_json(json, kNesting);
  if (!parsed) return not_understood(parsed.error().message);
  return read<T>(*parsed, "the result");
}

template Result<Done> decode_result<Done>(std::string_view);
template Result<HelloResult> decode_result<HelloResult>(std::string_view);
template Result<PingResult> decode_result<PingResult>(std::string_view);
template Result<Admission> decode_result<Admission>(std::string_view);
template Result<StopResult> decode_result<StopResult>(std::string_view);
template Result<StateResult> decode_result<StateResult>(std::string_view);
template Result<ClaimResult> decode_result<ClaimResult>(std::string_view);
template Result<GainResult> decode_result<GainResult>(std::string_view);
template Result<ForecastResult> decode_result<ForecastResult>(std::string_view);
template Result<RecenterResult> decode_result<RecenterResult>(std::string_view);
template Result<TelemetryResult> decode_result<TelemetryResult>(std::string_view);
template Result<EventsResult> decode_result<EventsResult>(std::string_view);
template Result<ConnectionsResult> decode_result<ConnectionsResult>(std::string_view);
template Result<DevicesResult> decode_result<DevicesResult>(std::string_view);
template Result<PreviewResult> decode_result<PreviewResult>(std::string_view);
template Result<HistoryResult> decode_result<HistoryResult>(std::string_view);
template Result<PatternSummary> decode_result<PatternSummary>(std::string_view);
template Result<PatternsResult> decode_result<PatternsResult>(std::string_view);
template Result<PatternResult> decode_result<PatternResult>(std::string_view);
template Result<SimResult> decode_result<SimResult>(std::string_view);
template Result<SimTruthResult> decode_result<SimTruthResult>(std::string_view);
template Result<Status> decode_result<Status>(std::string_view);
template Result<Description> decode_result<Description>(std::string_view);

}  // namespace hedgehog::protocol
