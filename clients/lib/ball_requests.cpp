// SPDX-License-Identifier: MIT
// Sending of a Ball's requests, and renewal of its subscriptions.
#include <utility>

#include "clients/lib/ball.h"

namespace hedgehog {

client::Outcome<protocol::Id> Ball::send(const client::AnyRequest& request) {
  const auto* raw = std::get_if<client::RawRequest>(&request);
  auto sent = raw != nullptr ? connection_->request_raw(raw->method, raw->params_json, kNow)
                             : connection_->request(std::get<protocol::Request>(request), kNow);
  if (!check_sent(sent ? client::Outcome<void>{} : sent.error()))
    return connected() ? sent.error() : *failure_;
  pending_.push_back({*sent, client::Clock::now() + options_.timeout});
  return sent;
}

std::optional<protocol::Id> Ball::request_any(const client::AnyRequest& request) {
  if (!connected()) return std::nullopt;
  auto sent = send(request);
  if (!sent) return std::nullopt;
  subscriptions_.on_request(*sent, request);
  return *std::move(sent);
}

bool Ball::notify_any(const client::AnyRequest& request) {
  if (!connected()) return false;
  const auto* raw = std::get_if<client::RawRequest>(&request);
  const bool sent =
      check_sent(raw != nullptr ? connection_->notify_raw(raw->method, raw->params_json, kNow)
                                : connection_->notify(std::get<protocol::Request>(request), kNow));
  if (sent) subscriptions_.on_notification(request);
  return sent;
}

bool Ball::notify(const protocol::Request& request) { return notify_any(request); }

bool Ball::notify_raw(std::string_view method, std::string_view params_json) {
  return notify_any(client::RawRequest{std::string(method), std::string(params_json)});
}

std::optional<protocol::Id> Ball::request(const protocol::Request& request) {
  return request_any(request);
}

std::optional<protocol::Id> Ball::request_raw(std::string_view method,
                                              std::string_view params_json) {
  return request_any(client::RawRequest{std::string(method), std::string(params_json)});
}

void Ball::renew_subscriptions() {
  for (const client::Subscriptions::Held& one : subscriptions_.current()) {
    const auto sent = send(one.request);
    if (!sent) return;
    subscriptions_.on_renewal(*sent, one);
    renewals_.push_back(*sent);
  }
}

void Ball::record_refused_renewal(const std::string& method, const protocol::RpcError& refusal) {
  if (refused_renewals_.size() >= kMaxRefused) refused_renewals_.pop_front();
  refused_renewals_.push_back(
      {client::Failure::kRefused, method + ": " + refusal.message, refusal});
}

std::optional<client::ClientError> Ball::refused_renewal() {
  if (refused_renewals_.empty()) return std::nullopt;
  std::optional<client::ClientError> oldest = std::move(refused_renewals_.front());
  refused_renewals_.pop_front();
  return oldest;
}

}  // namespace hedgehog
