// SPDX-License-Identifier: MIT
// Sending of a Ball's requests, and renewal of its subscriptions.
#include <utility>

#include "clients/lib/ball.h"

namespace hedgehog {

client::Outcome<protocol::Id> Ball::send(const client::AnyRequest& request) {
  const auto* raw = std::get_if<client::RawRequest>(&request);
  auto asked = raw != nullptr ? connection_->ask_raw(raw->method, raw->params_json, kNow)
                              : connection_->ask(std::get<protocol::Request>(request), kNow);
  if (!keep(asked ? client::Outcome<void>{} : asked.error()))
    return connected() ? asked.error() : *failure_;
  asked_.push_back({*asked, client::Clock::now() + options_.patience});
  return asked;
}

std::optional<protocol::Id> Ball::ask_any(const client::AnyRequest& request) {
  if (!connected()) return std::nullopt;
  auto asked = send(request);
  if (!asked) return std::nullopt;
  subscriptions_.asked(*asked, request);
  return *std::move(asked);
}

bool Ball::notify_any(const client::AnyRequest& request) {
  if (!connected()) return false;
  const auto* raw = std::get_if<client::RawRequest>(&request);
  const bool sent =
      keep(raw != nullptr ? connection_->notify_raw(raw->method, raw->params_json, kNow)
                          : connection_->notify(std::get<protocol::Request>(request), kNow));
  if (sent) subscriptions_.notified(request);
  return sent;
}

bool Ball::notify(const protocol::Request& request) { return notify_any(request); }

bool Ball::notify_raw(std::string_view method, std::string_view params_json) {
  return notify_any(client::RawRequest{std::string(method), std::string(params_json)});
}

std::optional<protocol::Id> Ball::ask(const protocol::Request& request) { return ask_any(request); }

std::optional<protocol::Id> Ball::ask_raw(std::string_view method, std::string_view params_json) {
  return ask_any(client::RawRequest{std::string(method), std::string(params_json)});
}

void Ball::renew_subscriptions() {
  for (const client::Subscriptions::Held& one : subscriptions_.current()) {
    const auto asked = send(one.request);
    if (!asked) return;
    subscriptions_.renewed(*asked, one);
    renewals_.push_back(*asked);
  }
}

void Ball::keep_refusal(const std::string& method, const protocol::RpcError& refusal) {
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
