// SPDX-License-Identifier: MIT
#include "tests/soak/subscriptions.h"

#include <utility>

#include "tests/soak/failure.h"
#include "tests/soak/json_text.h"

namespace hedgehog::soak {
namespace {

std::string text_of(const protocol::Json& object, std::string_view name) {
  const protocol::Json* found = object.find(name);
  const auto* text = found == nullptr ? nullptr : found->as<std::string>();
  return text == nullptr ? std::string() : *text;
}

}  // namespace

void Subscriptions::sent(const protocol::Incoming& incoming) {
  for (const protocol::Item& item : incoming.items) {
    if (item.request.has_error()) continue;
    const std::string_view method = protocol::name(*item.method);
    const bool telemetry = method.starts_with("telemetry.") && method.ends_with("subscribe");
    const bool events = method.starts_with("events.") && method.ends_with("subscribe");
    if (!telemetry && !events) continue;
    Stream& stream = telemetry ? telemetry_ : events_;
    if (incoming.batch || !item.id || item.id->json == "null") {
      stream.uncertain = true;
      ++stream.uncertain_sent;
      continue;
    }
    Request request{telemetry, std::nullopt, stream.uncertain_sent};
    if (const auto* wanted = std::get_if<protocol::EventsSubscribe>(&*item.request))
      request.names.emplace(wanted->types.begin(), wanted->types.end());
    requests_[item.id->json] = std::move(request);
  }
}

void Subscriptions::on_response(const CompletedRequest& completed) {
  const auto found = requests_.find(completed.id);
  if (found == requests_.end()) return;
  Request request = std::move(found->second);
  requests_.erase(found);
  if (completed.result == nullptr) return;
  Stream& stream = request.telemetry ? telemetry_ : events_;
  if (request.telemetry) {
    if (const protocol::Json* fields = completed.result->find("fields")) {
      request.names.emplace();
      for (const protocol::Json& field : *fields->as<protocol::Json::List>())
        request.names->insert(*field.as<std::string>());
    }
  }
  stream.names = std::move(request.names);
  if (request.uncertain_sent == stream.uncertain_sent) stream.uncertain = false;
}

void Subscriptions::notified(const protocol::Json& message) {
  const std::string method = text_of(message, "method");
  const protocol::Json* params = message.find("params");
  const bool telemetry = method == "telemetry";
  if ((!telemetry && method != "event") || params == nullptr || message.find("id") != nullptr)
    throw Failure("a notification that there is not: " + protocol::to_text(message));
  const std::string broken =
      protocol::violation(message_definitions(), telemetry ? "Telemetry" : "Event", *params);
  if (!broken.empty()) throw Failure("a wrong notification, " + broken);
  const Stream& stream = telemetry ? telemetry_ : events_;
  if (telemetry) {
    const protocol::Json* time_ns = params->find("time_ns");
    const auto* now = time_ns == nullptr ? nullptr : time_ns->as<std::int64_t>();
    if (now == nullptr || *now < last_time_ns_) throw Failure("telemetry goes back in time");
    last_time_ns_ = *now;
  }
  if (stream.uncertain) return;
  if (!stream.names) throw Failure("nothing subscribed to " + protocol::to_text(message));
  if (!telemetry) {
    if (!stream.names->empty() && !stream.names->contains(text_of(*params, "type")))
      throw Failure("an event of another type: " + protocol::to_text(*params));
    return;
  }
  for (const auto& [name, value] : *params->as<protocol::Json::Object>())
    if (name != "time_ns" && !stream.names->contains(name))
      throw Failure("telemetry that was not asked for: " + name);
}

}  // namespace hedgehog::soak
