// SPDX-License-Identifier: MIT
#include "daemon/server/dispatcher.h"

#include <algorithm>
#include <utility>

#include "daemon/server/handlers.h"

namespace hedgehog::server {
namespace {

std::string encoded(const protocol::Id& id, const Answer& answer) {
  return answer.has_error() ? protocol::encode_error(id, answer.error())
                            : protocol::encode_result(id, *answer);
}

protocol::RpcError too_many_forecasts() {
  protocol::RpcError e = protocol::busy("a batch may ask for 8 forecasts; ask again", 1);
  e.limit = std::int64_t{Dispatcher::kMaxForecasts};
  return e;
}

}  // namespace

void Dispatcher::line(Session& session, std::string_view text) {
  protocol::Incoming incoming = protocol::decode_line(text);
  const auto reply = std::make_shared<Reply>();
  reply->session = session.id;
  reply->batch = incoming.batch;
  for (protocol::Item& one : incoming.items) {
    item(session, one, reply);
  }
  services_.machine.outbox().commit();
  send_if_complete(*reply);
}

void Dispatcher::line_too_long(Session& session) {
  session.sink->send(protocol::encode_error({}, protocol::line_too_long()), LineKind::kAnswer);
}

void Dispatcher::item(Session& session, protocol::Item& item, const std::shared_ptr<Reply>& reply) {
  if (item.request.has_error()) {
    if (item.id) {
      reply->answers.push_back(protocol::encode_error(*item.id, item.request.error()));
    }
    return;
  }
  if (std::holds_alternative<protocol::ThermalForecast>(*item.request) &&
      (!item.id || ++reply->forecasts > kMaxForecasts)) {
    if (item.id) {
      reply->answers.push_back(protocol::encode_error(*item.id, too_many_forecasts()));
    }
    return;
  }
  Call call{services_, session, item.id.has_value()};
  Outcome outcome = carry_out(call, *item.request);
  if (!item.id) {
    return;
  }
  if (const Answer* answer = std::get_if<Answer>(&outcome)) {
    reply->answers.push_back(encoded(*item.id, *answer));
    return;
  }
  reply->answers.emplace_back();
  ++reply->open;
  waiting_.push_back({reply, reply->answers.size() - 1, *item.id,
                      std::get<Deferred>(std::move(outcome)), std::chrono::steady_clock::now()});
}

void Dispatcher::poll() {
  if (waiting_.empty()) {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(waiting_, [&](Waiting& w) {
    const auto answer = w.deferred.poll(services_, now - w.since > kPatience);
    if (!answer) {
      return false;
    }
    w.reply->answers[w.index] = encoded(w.id, *answer);
    --w.reply->open;
    send_if_complete(*w.reply);
    return true;
  });
}

bool Dispatcher::owes(ConnectionId session) const noexcept {
  return std::any_of(waiting_.begin(), waiting_.end(),
                     [&](const Waiting& w) { return w.reply->session == session; });
}

void Dispatcher::send_if_complete(const Reply& reply) {
  if (reply.open > 0 || reply.answers.empty()) {
    return;
  }
  const auto session = services_.sessions.find(reply.session);
  if (session == services_.sessions.end()) {
    return;
  }
  session->second->sink->send(
      reply.batch ? protocol::encode_batch(reply.answers) : reply.answers.front(),
      LineKind::kAnswer);
}

}  // namespace hedgehog::server
