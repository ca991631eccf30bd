// SPDX-License-Identifier: MIT
#include "clients/mqtt/remote_requests.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "protocol/server_codec.h"

namespace hedgehog::mqtt {

namespace {

using Json = nlohmann::ordered_json;

Json object_of(const protocol::Result<std::string>& result) {
  if (result) return {{"result", Json::parse(*result)}};
  return {{"error", Json::parse(protocol::encode_error({}, result.error()))["error"]}};
}

/// What a method allows to the role `operate` only: the bridge has that role by its user's group,
/// clients of a broker have `play`.
std::optional<protocol::RpcError> not_permitted(const Json& params) {
  using protocol::Role;
  for (const auto& [field, value] : {std::pair("frame", "coil"), std::pair("scope", "all")})
    if (params.value(field, Json()) == Json(value))
      return protocol::forbidden(field, value, Role::kOperate, Role::kPlay);
  constexpr int kMaxPriority = 7;
  const auto priority = params.find("priority");
  if (priority != params.end() && priority->is_number() && *priority > kMaxPriority)
    return protocol::forbidden("priority", priority->dump(), Role::kOperate, Role::kPlay);
  return std::nullopt;
}

}  // namespace

protocol::Result<RemoteRequest> remote_request(const Topics& topics, const Message& message) {
  auto method = topics.method(message.topic);
  if (!method) {
    std::string allowed;
    for (const auto& name : remote_methods()) allowed += (allowed.empty() ? "" : ", ") + name;
    return protocol::error(protocol::ErrorCode::kMethodNotFound,
                           message.topic + ": unknown method; allowed are " + allowed);
  }
  // The payload of a Home Assistant button is a word.
  if (message.payload.empty() || message.topic == topics.emergency_stop())
    return RemoteRequest{*std::move(method), "{}"};
  const Json params = Json::parse(message.payload, nullptr, false);
  if (!params.is_object())
    return protocol::error(protocol::ErrorCode::kInvalidParams,
                           "the payload is no JSON object with the parameters of " + *method);
  if (auto refusal = not_permitted(params)) return *std::move(refusal);
  return RemoteRequest{*std::move(method), params.dump()};
}

std::vector<Message> response_to(const Topics& topics, const Message& request,
                                 const protocol::Result<std::string>& result) {
  Message response;
  response.delivery = Delivery::kQos1;
  Json body = object_of(result);
  if (!request.response_topic.empty()) {
    response.topic = request.response_topic;
    response.correlation = request.correlation;
  } else if (!result) {
    response.topic = topics.refused();
    body["topic"] = request.topic;
  } else {
    return {};
  }
  response.payload = body.dump(-1, ' ', false, Json::error_handler_t::replace);
  return {std::move(response)};
}

std::vector<Message> PendingRequests::take(const Topics& topics, const protocol::Reply& reply) {
  auto found = requests_.extract(reply.id.json);
  if (found.empty()) return {};
  return response_to(topics, found.mapped(), reply.result);
}

std::vector<Message> PendingRequests::take_all(const Topics& topics) {
  std::vector<Message> responses;
  const auto gone =
      protocol::error(protocol::ErrorCode::kDeviceAbsent, "no connection to the daemon");
  for (const auto& [id, request] : std::exchange(requests_, {}))
    for (auto& response : response_to(topics, request, gone))
      responses.push_back(std::move(response));
  return responses;
}

}  // namespace hedgehog::mqtt
