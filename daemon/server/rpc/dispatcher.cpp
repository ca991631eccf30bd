// SPDX-License-Identifier: MIT
#include "daemon/server/rpc/dispatcher.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

std::string encoded(const protocol::Id& id, const Response& response) {
  return response.has_error() ? protocol::encode_error(id, response.error())
                              : protocol::encode_result(id, *response);
}

/// Name of the results that take io long to compute; nullptr: short.
const char* costly(protocol::Method method) {
  if (method == protocol::kMethodOf<protocol::ThermalForecast>) return "forecasts";
  if (method == protocol::kMethodOf<protocol::PatternList>) return "lists of patterns";
  if (method == protocol::kMethodOf<protocol::EventsHistory> ||
      method == protocol::kMethodOf<protocol::TelemetryHistory>)
    return "histories";
  return nullptr;
}

/// The request may start a current, or exclude other clients from the ball.
bool starts_something(const protocol::Request& request) {
  return std::holds_alternative<protocol::EffectStart>(request) ||
         std::holds_alternative<protocol::EffectUpdate>(request) ||
         std::holds_alternative<protocol::DeviceArm>(request) ||
         std::holds_alternative<protocol::DeviceClaim>(request);
}

/// Time after which a retry is useful.
constexpr std::int64_t kRestartMs = 1000;

protocol::RpcError too_many(const std::string& what) {
  protocol::RpcError e =
      protocol::busy("a batch may contain at most " + std::to_string(Dispatcher::kMaxCostly) + " " +
                         what + "; send the others separately",
                     1);
  e.limit = std::int64_t{Dispatcher::kMaxCostly};
  return e;
}

void count(Counters& counters, protocol::Method method, const Response& response) {
  if (response.has_error()) {
    const protocol::ErrorCode code = response.error().code;
    counters.requests.add(method, code);
    if (code == protocol::ErrorCode::kRefusedThermal)
      ++counters.effects[{protocol::name(method), "refused"}];
    return;
  }
  counters.requests.add(method, std::nullopt);
  if (const auto* admission = std::get_if<protocol::Admission>(&*response))
    for (const std::string_view by : {"thermal", "mix", "priority", "configuration"})
      if (admission->limited_by == by) ++counters.limited[by];
}

}  // namespace

void Dispatcher::Reply::add(std::string response) {
  bytes += response.size();
  responses.push_back(std::move(response));
}

std::size_t Dispatcher::Reply::reserve() {
  responses.emplace_back();
  ++open;
  bytes += kReservedBytes;
  return responses.size() - 1;
}

void Dispatcher::Reply::fill(std::size_t index, std::string response) {
  bytes = bytes - kReservedBytes + response.size();
  responses[index] = std::move(response);
  --open;
}

void Dispatcher::line(Session& session, std::string_view text) {
  protocol::Incoming incoming = protocol::decode_line(text);
  const auto reply = std::make_shared<Reply>();
  reply->session = session.id;
  reply->batch = incoming.batch;
  for (protocol::Item& one : incoming.items) item(session, one, reply);
  context_.device_view.outbox().commit();
  complete(*reply);
  session.open_bytes += reply->open_bytes();
  send_if_complete(*reply);
}

void Dispatcher::complete(Reply& reply) {
  for (const Completion& one : completions_) {
    const Response response = one.work.complete();
    count(context_.counters, one.method, response);
    reply.fill(one.index, encoded(one.id, response));
  }
  completions_.clear();
}

void Dispatcher::line_too_long(Session& session) {
  context_.counters.requests.add(std::nullopt, protocol::line_too_long().code);
  session.sink->send(protocol::encode_error({}, protocol::line_too_long()), LineKind::kResponse);
}

bool Dispatcher::has_emergency_stop(std::string_view line) {
  const protocol::Incoming incoming = protocol::decode_line(line);
  return std::any_of(incoming.items.begin(), incoming.items.end(), [](const protocol::Item& item) {
    return item.request && std::holds_alternative<protocol::DeviceEmergencyStop>(*item.request);
  });
}

void Dispatcher::item(Session& session, protocol::Item& item, const std::shared_ptr<Reply>& reply) {
  if (item.request.has_error()) {
    context_.counters.requests.add(std::nullopt, item.request.error().code);
    if (item.id) reply->add(protocol::encode_error(*item.id, item.request.error()));
    return;
  }
  const protocol::Method method = protocol::method_of(*item.request);
  const char* what = costly(method);
  if (what != nullptr && !item.id) return;
  // A stop is persisted as a latch for the next start, and never rejected because of a later line.
  if (method != protocol::kMethodOf<protocol::DeviceEmergencyStop>) {
    std::optional<protocol::RpcError> why_not;
    if (context_.stopping)
      why_not = protocol::busy("the daemon is stopping", kRestartMs);
    else if (session.bypassed > 0 && starts_something(*item.request))
      why_not = protocol::busy(
          "superseded by a later emergency stop, or by the end of the connection", 1);
    else if (what != nullptr && ++reply->costly[method] > kMaxCostly)
      why_not = too_many(what);
    else if (reply->bytes > session.batch_bytes)
      why_not = protocol::busy(
          "the responses to this batch are too long; send the remaining requests separately", 1);
    if (why_not) {
      count(context_.counters, method, *why_not);
      if (item.id) reply->add(protocol::encode_error(*item.id, *why_not));
      return;
    }
  }
  Call call{context_, session, item.id.has_value()};
  Outcome outcome = carry_out(call, *item.request);
  const Response* response = std::get_if<Response>(&outcome);
  if (response != nullptr) count(context_.counters, method, *response);
  if (!item.id) return;
  if (const Encoded* known = std::get_if<Encoded>(&outcome)) {
    context_.counters.requests.add(method, std::nullopt);
    reply->add(protocol::encode_encoded(*item.id, *known->result));
    return;
  }
  if (response != nullptr) {
    reply->add(encoded(*item.id, *response));
    return;
  }
  if (AfterCommit* later = std::get_if<AfterCommit>(&outcome)) {
    completions_.push_back({reply->reserve(), *item.id, method, std::move(*later)});
    return;
  }
  waiting_.push_back({reply, reply->reserve(), *item.id, method,
                      std::get<Deferred>(std::move(outcome)),
                      PolledTime(PolledTime::Clock::now())});
}

void Dispatcher::poll() {
  if (waiting_.empty()) return;
  const auto now = PolledTime::Clock::now();
  std::erase_if(waiting_, [&](Waiting& w) {
    const auto session = context_.sessions.find(w.reply->session);
    if (session == context_.sessions.end()) return true;
    w.waited.poll(now);
    const auto response = w.deferred.poll(context_, w.waited.elapsed() > kTimeout);
    if (!response) return false;
    count(context_.counters, w.method, *response);
    session->second->open_bytes -= w.reply->open_bytes();
    w.reply->fill(w.index, encoded(w.id, *response));
    session->second->open_bytes += w.reply->open_bytes();
    send_if_complete(*w.reply);
    return true;
  });
}

std::size_t Dispatcher::pending(ConnectionId session) const noexcept {
  const auto count = std::count_if(waiting_.begin(), waiting_.end(),
                                   [&](const Waiting& w) { return w.reply->session == session; });
  return static_cast<std::size_t>(count);
}

void Dispatcher::send_if_complete(Reply& reply) {
  if (reply.open > 0 || reply.responses.empty()) return;
  const auto session = context_.sessions.find(reply.session);
  if (session == context_.sessions.end()) return;
  session->second->sink->send(
      reply.batch ? protocol::encode_batch(reply.responses) : std::move(reply.responses.front()),
      LineKind::kResponse);
}

}  // namespace hedgehog::server
