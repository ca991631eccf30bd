// SPDX-License-Identifier: MIT
#include "clients/lib/subscriptions.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "protocol/client_codec.h"
#include "protocol/server_codec.h"

namespace hedgehog::client {
namespace {

std::string_view method_of(const AnyRequest& request) {
  if (const auto* raw = std::get_if<RawRequest>(&request)) return raw->method;
  return protocol::name(protocol::method_of(std::get<protocol::Request>(request)));
}

bool begins(std::string_view method) { return method.ends_with(".subscribe"); }
bool ends(std::string_view method) { return method.ends_with(".unsubscribe"); }
std::string_view topic(std::string_view method) { return method.substr(0, method.rfind('.')); }

bool concerns(const AnyRequest& request) {
  return begins(method_of(request)) || ends(method_of(request));
}

/// With the daemon's decoder. Methods that only later versions have cannot be checked here.
bool is_carried_out(const AnyRequest& request) {
  const auto* raw = std::get_if<RawRequest>(&request);
  const auto line = protocol::decode_line(
      raw != nullptr
          ? protocol::encode_raw_request(std::nullopt, raw->method, raw->params_json)
          : protocol::encode_request(std::nullopt, std::get<protocol::Request>(request)));
  const auto& read = line.items.front().request;
  return read || read.error().code == protocol::ErrorCode::kMethodNotFound;
}

}  // namespace

void Subscriptions::on_notification(const AnyRequest& request) {
  if (concerns(request) && is_carried_out(request)) apply({++last_order_, request});
}

void Subscriptions::on_request(const protocol::Id& id, const AnyRequest& request) {
  if (concerns(request)) pending_.push_back({id, {++last_order_, request}, false});
}

void Subscriptions::on_renewal(const protocol::Id& id, const Held& one) {
  pending_.push_back({id, one, true});
}

std::optional<std::string> Subscriptions::on_response(const protocol::Id& id, bool accepted) {
  const auto found = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& one) { return one.id == id; });
  if (found == pending_.end()) return std::nullopt;
  const Pending one = std::move(*found);
  pending_.erase(found);
  if (!one.renewal) {
    if (accepted) apply(one.change);
    return std::nullopt;
  }
  // The program may have ended or replaced it meanwhile.
  const auto ended = accepted ? 0 : std::erase_if(current_, [&](const Held& held) {
    return held.order == one.change.order;
  });
  return ended > 0 ? std::optional<std::string>(method_of(one.change.request)) : std::nullopt;
}

void Subscriptions::apply(const Held& change) {
  const std::string_view method = method_of(change.request);
  std::uint64_t& newest = applied_[std::string(topic(method))];
  if (change.order < newest) return;
  newest = change.order;
  std::erase_if(current_,
                [&](const Held& held) { return topic(method_of(held.request)) == topic(method); });
  if (begins(method)) current_.push_back(change);
}

}  // namespace hedgehog::client
