// SPDX-License-Identifier: MIT
// How a Ball's requests are sent, and which of them the next connection makes again.
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
  for (const client::AnyRequest& one : subscriptions_.current()) {
    const auto asked = send(one);
    if (!asked) return;
    renewals_.push_back(*asked);
  }
}

}  // namespace hedgehog
