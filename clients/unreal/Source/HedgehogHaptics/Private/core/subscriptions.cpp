// SPDX-License-Identifier: MIT
#include "core/subscriptions.h"

#include <algorithm>
#include <string_view>

namespace hedgehog::unreal {
namespace {

constexpr std::string_view kBegins = ".subscribe";
constexpr std::string_view kEnds = ".unsubscribe";

bool ends_with(std::string_view method, std::string_view verb) {
  return method.size() > verb.size() && method.substr(method.size() - verb.size()) == verb;
}

/// "events"; empty: the method does not concern a subscription.
std::string_view kind_of(std::string_view method) {
  for (const std::string_view verb : {kBegins, kEnds})
    if (ends_with(method, verb)) return method.substr(0, method.size() - verb.size());
  return {};
}

template <class Is>
void remove(std::vector<Subscriptions::Change>& changes, Is is) {
  changes.erase(std::remove_if(changes.begin(), changes.end(), is), changes.end());
}

}  // namespace

std::int64_t Subscriptions::asked(const std::string& method, const Json& params) {
  if (kind_of(method).empty()) return 0;
  changes_.push_back({++last_order_, method, params, false});
  return last_order_;
}

void Subscriptions::notified(const std::string& method, const Json& params) {
  const std::int64_t order = asked(method, params);
  if (order > 0) answered(order, Answer());
}

std::vector<Subscriptions::Change> Subscriptions::renew(const std::vector<std::int64_t>& queued) {
  std::vector<Change> newest;
  for (const Change& one : changes_) {
    remove(newest,
           [&](const Change& older) { return kind_of(older.method) == kind_of(one.method); });
    newest.push_back(one);
  }
  changes_ = std::move(newest);
  std::vector<Change> due;
  for (Change& one : changes_) {
    if (std::find(queued.begin(), queued.end(), one.order) != queued.end()) continue;
    one.renewal = true;
    if (ends_with(one.method, kBegins)) due.push_back(one);
  }
  return due;
}

bool Subscriptions::answered(std::int64_t order, const Answer& answer) {
  const auto found = std::find_if(changes_.begin(), changes_.end(),
                                  [order](const Change& one) { return one.order == order; });
  if (found == changes_.end()) return false;
  const Change one = *found;
  const auto is_of_kind = [&one](const Change& other) {
    return kind_of(other.method) == kind_of(one.method);
  };
  if (answer.ok()) {
    remove(changes_, [&](const Change& other) { return is_of_kind(other) && other.order < order; });
    return false;
  }
  if (answer.failure != Failure::kRefused) return false;
  changes_.erase(found);
  return one.renewal && std::none_of(changes_.begin(), changes_.end(), is_of_kind);
}

}  // namespace hedgehog::unreal
