// SPDX-License-Identifier: MIT
#include "clients/lib/subscriptions.h"

#include <algorithm>
#include <string_view>

namespace hedgehog::client {
namespace {

std::string_view method_of(const AnyRequest& request) {
  if (const auto* raw = std::get_if<RawRequest>(&request)) return raw->method;
  return protocol::name(protocol::method_of(std::get<protocol::Request>(request)));
}

bool begins(std::string_view method) { return method.ends_with(".subscribe"); }
bool ends(std::string_view method) { return method.ends_with(".unsubscribe"); }
std::string_view topic(std::string_view method) { return method.substr(0, method.rfind('.')); }

}  // namespace

void Subscriptions::notified(const AnyRequest& request) {
  const std::string_view method = method_of(request);
  if (!begins(method) && !ends(method)) return;
  std::erase_if(current_,
                [&](const AnyRequest& one) { return topic(method_of(one)) == topic(method); });
  if (begins(method)) current_.push_back(request);
}

void Subscriptions::asked(const protocol::Id& id, const AnyRequest& request) {
  const std::string_view method = method_of(request);
  if (begins(method) || ends(method)) pending_.emplace_back(id, request);
}

void Subscriptions::answered(const protocol::Id& id, bool accepted) {
  const auto found = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const auto& one) { return one.first == id; });
  if (found == pending_.end()) return;
  const AnyRequest request = std::move(found->second);
  pending_.erase(found);
  if (accepted) notified(request);
}

}  // namespace hedgehog::client
