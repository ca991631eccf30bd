// SPDX-License-Identifier: MIT
#include "core/client.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace hedgehog::unreal {

double felt_level(double strength, const Json& limits) {
  const double most_a = limits["current_a"].number();
  if (!(strength > 0.0) || !(most_a > 0.0)) return 0.0;
  const double felt = std::min(1.0, limits["felt_a"].number() / most_a);
  return felt + (1.0 - felt) * std::min(1.0, strength);
}

Client::Client(Settings settings, Connect connect, Listeners listeners)
    : settings_(std::move(settings)),
      connect_(std::move(connect)),
      listeners_(std::move(listeners)) {}

void Client::poll(double now_s) {
  now_s_ = now_s;
  report_later();
  if (closed_) return;
  if (session_ == nullptr) {
    if (remaining_s() <= 0.0) connect();
    return;
  }
  const std::shared_ptr<Session> session = session_;
  session->poll(now_s);
  // A listener may have closed it.
  if (session != session_) return;
  if (!session->ended().empty())
    lose();
  else if (session->is_open() && !greeted_)
    begin();
}

void Client::close() {
  closed_ = true;
  end("this ball is closed", Json());
}

void Client::request(const std::string& method, const Json& params, OnAnswer on_answer) {
  const std::string where = params.non_finite();
  if (!where.empty()) {
    fail_later(std::move(on_answer), failed(Failure::kBadValue, where + ": is no number"));
    return;
  }
  Waiting one{method, params, std::move(on_answer), subscriptions_.asked(method, params)};
  if (closed_) {
    fail_later(std::move(one.on_answer), failed(Failure::kNotConnected, "this ball is closed"));
  } else if (session_ == nullptr && remaining_s() > 0.0) {
    char message[80];
    std::snprintf(message, sizeof message, "the daemon does not run; next attempt in %.1f s",
                  remaining_s());
    fail_later(std::move(one.on_answer), failed(Failure::kNotConnected, message, remaining_s()));
  } else if (is_open()) {
    ask(std::move(one));
  } else {
    queue_.push_back(std::move(one));
  }
}

void Client::ask(Waiting one) {
  OnAnswer settle = [this, change = one.change,
                     on_answer = std::move(one.on_answer)](const Answer& answer) {
    subscriptions_.answered(change, answer);
    on_answer(answer);
  };
  session_->ask(one.method, one.params.without_nulls(), std::move(settle), now_s_);
}

bool Client::notify(const std::string& method, const Json& params) {
  if (!is_open() || !params.non_finite().empty()) return false;
  subscriptions_.notified(method, params);
  session_->notify(method, params.without_nulls());
  return true;
}

bool Client::rumble(const std::string& slot, double strength, const Json& direction,
                    const Json& params) {
  if (!(strength > 0.0)) return notify("effect.stop", Json::object({{"slot", slot}}));
  if (!is_open()) return false;
  Json effect = params;
  effect.set("slot", slot);
  effect.set("direction", direction);
  if (effect["lease_ms"].is(Json::Kind::kNull)) effect.set("lease_ms", kLeaseMs);
  effect.set("level", felt_level(strength, hello()["limits"]));
  return notify("effect.vibrate", effect);
}

void Client::renew(const Subscriptions::Change& one) {
  const OnAnswer settle = [this, order = one.order, method = one.method](const Answer& answer) {
    if (subscriptions_.answered(order, answer) && listeners_.subscription_ended)
      listeners_.subscription_ended(method, answer);
  };
  session_->ask(one.method, one.params.without_nulls(), settle, now_s_);
}

const Json& Client::hello() const {
  static const Json kNone;
  return is_open() ? session_->hello() : kNone;
}

std::string Client::shown_token() const {
  const char* const named = std::getenv("HEDGEHOG_TOKEN");
  return settings_.token.empty() && named != nullptr ? named : settings_.token;
}

void Client::connect() {
  place_ = find_daemon(settings_.address);
  if (!place_.error.empty()) {
    back_off();
    if (!reported_ && listeners_.disconnected) listeners_.disconnected(place_.error);
    reported_ = true;
    fail_all({}, failed(Failure::kBadAddress, place_.error, remaining_s()));
    return;
  }
  Json introduction = Json::object({{"client", settings_.name}, {"protocol", "1"}});
  const std::string token = shown_token();
  if (!token.empty()) introduction.set("token", token);
  session_ =
      std::make_shared<Session>(connect_(place_), std::move(introduction), settings_.timeout_s,
                                now_s_, [this](const std::string& method, const Json& params) {
                                  if (listeners_.notification)
                                    listeners_.notification(method, params);
                                });
}

void Client::begin() {
  greeted_ = true;
  reported_ = false;
  wait_s_ = 0.0;
  next_attempt_s_ = 0.0;
  std::vector<Waiting> queued = std::exchange(queue_, {});
  std::vector<std::int64_t> changes;
  for (const Waiting& one : queued) changes.push_back(one.change);
  for (const Subscriptions::Change& one : subscriptions_.renew(changes)) renew(one);
  for (Waiting& one : queued) ask(std::move(one));
  if (listeners_.connected) listeners_.connected(hello());
}

/// The connection was lost, could not be established, or the hello was refused.
void Client::lose() {
  back_off(session_->retry_after_s());
  std::string reason = "the connection to the daemon has ended: " + session_->ended();
  if (!session_->was_reached())
    reason = "the daemon does not run: " + to_string(place_) + ": " + session_->ended();
  else if (!session_->refusal().is(Json::Kind::kNull))
    reason = session_->ended();
  // A copy: the session is destroyed.
  end(reason, Json(session_->refusal()));
}

void Client::end(const std::string& reason, const Json& refusal) {
  const bool was_open = greeted_;
  greeted_ = false;
  const Answer answer = refusal.is(Json::Kind::kNull)
                            ? failed(Failure::kNotConnected, reason, remaining_s())
                            : refusal_of(refusal);
  std::vector<OnAnswer> unanswered;
  if (session_ != nullptr) unanswered = session_->close(reason);
  session_.reset();
  fail_all(std::move(unanswered), answer);
  const bool report = !closed_ && (was_open || !reported_);
  reported_ = true;
  if (report && listeners_.disconnected) listeners_.disconnected(reason);
}

void Client::fail_all(std::vector<OnAnswer> unanswered, const Answer& answer) {
  for (Waiting& one : std::exchange(queue_, {})) unanswered.push_back(std::move(one.on_answer));
  for (const OnAnswer& one : unanswered) one(answer);
}

void Client::fail_later(OnAnswer on_answer, Answer answer) {
  later_.emplace_back(std::move(on_answer), std::move(answer));
}

void Client::report_later() {
  for (const auto& [on_answer, answer] : std::exchange(later_, {})) on_answer(answer);
}

void Client::back_off(double min_s) {
  wait_s_ = wait_s_ > 0.0 ? std::min(kMaxWaitS, 2.0 * wait_s_) : kFirstWaitS;
  next_attempt_s_ = now_s_ + std::max(wait_s_, min_s);
}

double Client::remaining_s() const { return std::max(0.0, next_attempt_s_ - now_s_); }

}  // namespace hedgehog::unreal
